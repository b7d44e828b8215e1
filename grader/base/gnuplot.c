#include "base/gnuplot.h"

#include "scene/check.h"
#include "base/process.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>

enum { MOST_SECONDS = 120 };

bool gnuplot_run(const char *folder, const char *script) {
    static Process process; // holds what was printed: too large for a stack
    char path[4096];
    snprintf(path, sizeof path, "PATH=%s",
             getenv("PATH") ? getenv("PATH") : "/usr/local/bin:/usr/bin:/bin:/opt/homebrew/bin");
    char *const arguments[] = {"gnuplot", (char *)script, NULL};
    char *const environment[] = {path, "LC_ALL=C", NULL};
    const ProcessLimits limits = {.wall_seconds = MOST_SECONDS};
    if (!process_start(&process, arguments, environment, folder, &limits))
        return false;
    process_wait(&process);
    bool ok = process.state == PROCESS_ENDED && WIFEXITED(process.status) && WEXITSTATUS(process.status) == 0;
    if (!ok)
        check_fail("gnuplot could not draw %s/%s (is it installed? common/setup --test): %.300s", folder,
                   script, process.text);
    process_stop(&process);
    return ok;
}
