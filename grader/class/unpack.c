#include "unpack.h"

#include "check.h"
#include "process.h"

#include <string.h>
#include <sys/wait.h>

Unpacked unpack(const char *archive, const char *folder) {
    static Process process;
    char *arguments[] = {"bsdtar", "-xf", (char *)archive, NULL};
    char *environment[] = {"PATH=/usr/bin:/bin", "LC_ALL=C.UTF-8", NULL};
    const ProcessLimits limits = {.wall_seconds = 20, .cpu_seconds = 10, .memory_mib = 512, .file_mib = 4};
    if (!process_start(&process, arguments, environment, folder, &limits))
        return UNPACK_FAILED;
    process_wait(&process);
    bool ok = process.state == PROCESS_ENDED && WIFEXITED(process.status) && WEXITSTATUS(process.status) == 0;
    process_stop(&process);
    if (ok)
        return UNPACK_OK;
    check_fail("the archive cannot be unpacked: %.300s", process.text);
    return UNPACK_REFUSED;
}
