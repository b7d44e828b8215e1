#include "compile.h"

#include "check.h"
#include "home.h"
#include "process.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

// gcc's process with everything that it says in process->text.
static bool run_tool(Process *process, char *const *arguments, const char *folder) {
    char path[FILES_PATH] = "PATH=";
    check_append(path, sizeof path, "%s", getenv("PATH") ? getenv("PATH") : "/usr/bin:/bin");
    char *environment[] = {path, "LC_ALL=C", "TMPDIR=.", NULL};
    const ProcessLimits limits = {.wall_seconds = 20, .cpu_seconds = 10, .memory_mib = 2048, .file_mib = 16};
    if (!process_start(process, arguments, environment, folder, &limits))
        return false;
    process_wait(process);
    bool ok =
        process->state == PROCESS_ENDED && WIFEXITED(process->status) && WEXITSTATUS(process->status) == 0;
    process_stop(process);
    return ok;
}

bool compile_lab(const char *folder, char log[COMPILE_LOG]) {
    static _Thread_local Process process;
    char common[FILES_PATH], packages[FILES_PATH];
    home_path(common, "common");
    home_build_path(packages, "include");
    char *arguments[] = {"gcc",
                         "-std=c11",
                         "-Wall",
                         "-Wextra",
                         "-O0",
                         "-g",
                         "-fPIC",
                         "-shared",
                         "-I",
                         common,
                         "-isystem",
                         packages,
                         "-D_GNU_SOURCE",
                         "-DCGLM_ALL_UNALIGNED",
                         "-fmax-errors=20",
                         "-o",
                         "lab.so",
                         "./lab.c",
                         "-lm",
                         NULL};
    bool ok = run_tool(&process, arguments, folder);
    snprintf(log, COMPILE_LOG, "%.*s", COMPILE_LOG - 1, process.text);
    if (ok)
        return true;
    return check_fail(process.state == PROCESS_ENDED
                          ? "lab.c does not compile"
                          : "the compiler was stopped: lab.c takes too long to compile");
}

static bool locate_one(const char *folder, const char *offset, char *place, size_t size) {
    static _Thread_local Process process;
    char *arguments[] = {"addr2line", "-s", "-e", "lab.so", (char *)offset, NULL};
    if (!run_tool(&process, arguments, folder) || process.text[0] == '?')
        return false;
    snprintf(place, size, "%.*s", (int)strcspn(process.text, " \n"), process.text);
    return true;
}

void compile_locate(const char *folder, char *text, size_t size) {
    char *mark = strstr(text, " @0x");
    char *end = mark ? strchr(mark + 2, '@') : NULL;
    if (!end)
        return;
    char offset[32], place[128] = "", rest[1024];
    snprintf(offset, sizeof offset, "%.*s", (int)(end - mark - 2), mark + 2);
    snprintf(rest, sizeof rest, "%s", end + 1);
    bool found = locate_one(folder, offset, place, sizeof place);
    *mark = '\0';
    check_append(text, size, "%s%s%s%s", found ? " (" : "", place, found ? ")" : "", rest);
}
