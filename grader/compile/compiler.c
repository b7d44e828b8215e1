// Runs gcc in the jail with fixed arguments, takes its lab.so, and asks addr2line for the line of a place in
// it.
#include "compile/compiler.h"

#include "scene/check.h"
#include "base/files.h"
#include "compile/given.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

enum { MAX_LIBRARY_MIB = 16 };

// A tool's process with everything that it says in process->text.
static bool run_tool(Process *process, char *const *arguments, const char *folder, const char *out,
                     const Jail *jail) {
    char path[FILES_PATH] = "PATH=";
    const char *ours = getenv("PATH");
    check_append(path, sizeof path, "%s", jail || !ours ? "/usr/local/bin:/usr/bin:/bin" : ours);
    char *environment[] = {path, "LC_ALL=C", out ? "TMPDIR=out" : "TMPDIR=.", NULL};
    const JailPlan plan = {
        .kind = JAIL_TOOLS,
        .limits = {.wall_seconds = 20, .cpu_seconds = 5, .memory_mib = 2048, .file_mib = MAX_LIBRARY_MIB},
        .folder = folder,
        .writable = out};
    if (!jail_start(jail, &plan, process, arguments, environment))
        return false;
    process_wait(process);
    bool ok =
        process->state == PROCESS_ENDED && WIFEXITED(process->status) && WEXITSTATUS(process->status) == 0;
    process_stop(process);
    return ok;
}

// The flags are those of common/lab.flags, with which the Makefile precompiles given.h.
static bool run_gcc(Process *process, const char *folder, const char *out, const Jail *jail, bool address) {
    char common[FILES_PATH], packages[FILES_PATH], flags[FILES_PATH + 16], scene[FILES_PATH + 16];
    jail_part(jail, "common", common);
    jail_part(jail, "include", packages);
    snprintf(flags, sizeof flags, "@%s/lab.flags", common);
    snprintf(scene, sizeof scene, "%s/scene", common);
    // What later labs are given is told by files in given/, which come first.
    char *arguments[] = {"gcc",
                         flags,
                         "-Wall",
                         "-Wextra",
                         "-shared",
                         "-Igiven",
                         "-I",
                         common,
                         "-I",
                         scene,
                         "-isystem",
                         packages,
                         "-include",
                         address ? "lab.h" : "given.h", // which was compiled without it
                         "-include",
                         "earlier.h",
                         "-fmax-errors=20",
                         "-Wl,-rpath,$ORIGIN/given",
                         "-o",
                         out ? "out/lab.so" : "lab.so",
                         "./lab.c",
                         "given/given.so",
                         "-lm",
                         address ? "-fsanitize=address" : NULL,
                         NULL};
    return run_tool(process, arguments, folder, out, jail);
}

// What the jail wrote is as untrusted as what it was made from.
static bool take_library(const char *folder, const char *out) {
    char library[FILES_PATH];
    files_join(library, folder, "lab.so");
    return files_take(out, "lab.so", library, MAX_LIBRARY_MIB << 20);
}

static bool build(const char *folder, const Jail *jail, char log[COMPILE_LOG], bool address) {
    static _Thread_local Process process;
    char out[FILES_PATH];
    files_join(out, folder, "out");
    if (!given_place(folder, "all", jail) || (jail && !files_make_folder(out)))
        return false;
    bool ok = run_gcc(&process, folder, jail ? out : NULL, jail, address);
    snprintf(log, COMPILE_LOG, "%.*s", COMPILE_LOG - 1, process.text);
    if (!ok)
        check_fail(process.state == PROCESS_ENDED
                       ? "lab.c does not compile"
                       : "the compiler was stopped: lab.c takes too long to compile");
    ok = ok && (!jail || take_library(folder, out));
    if (jail)
        files_remove(out);
    return ok;
}

bool compiler_build(const char *folder, const Jail *jail, char log[COMPILE_LOG]) {
    return build(folder, jail, log, false);
}

bool compiler_build_for_address(const char *folder, const Jail *jail, char log[COMPILE_LOG]) {
    return build(folder, jail, log, true);
}

bool compiler_locate(const char *folder, const Jail *jail, uint64_t offset, char place[COMPILE_PLACE]) {
    static _Thread_local Process process;
    char number[32];
    snprintf(number, sizeof number, "0x%llx", (unsigned long long)offset);
    char *arguments[] = {"addr2line", "-s", "-e", "lab.so", number, NULL};
    if (!run_tool(&process, arguments, folder, NULL, jail) || process.text[0] == '?')
        return false;
    snprintf(place, COMPILE_PLACE, "%.*s", (int)strcspn(process.text, " \n"), process.text);
    return true;
}
