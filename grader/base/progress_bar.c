#include "base/progress_bar.h"

#include "base/process.h"

#include <stdio.h>
#include <unistd.h>

enum { WIDTH = 30 };

static void show(ProgressBar *bar) {
    int percent = bar->all > 0 ? 100 * bar->done / bar->all : 100;
    if (!bar->terminal || percent == bar->shown)
        return;
    bar->shown = percent;
    int steps = bar->done - bar->began;
    double passed = process_now() - bar->started;
    double left = steps > 0 ? passed / steps * (bar->all - bar->done) : 0;
    fprintf(stderr, "\r%-10s [", bar->scene);
    for (int i = 0; i < WIDTH; i++)
        fputc(i < percent * WIDTH / 100 ? '#' : ' ', stderr);
    fprintf(stderr, "] %3d %%, %3.0f s left ", percent, left);
}

void progress_bar_begin(ProgressBar *bar, const char *scene, int done, int all) {
    *bar = (ProgressBar){.terminal = isatty(STDERR_FILENO),
                         .started = process_now(),
                         .scene = scene,
                         .done = done,
                         .all = all,
                         .began = done,
                         .shown = -1};
    if (!bar->terminal)
        fprintf(stderr, "%s: %d steps, %d of them done before\n", scene, all, done);
    show(bar);
}

void progress_bar_step(ProgressBar *bar) {
    bar->done++;
    show(bar);
}

void progress_bar_end(ProgressBar *bar) {
    if (bar->terminal)
        fprintf(stderr, "\r%-79s\r", "");
    fprintf(stderr, "%s: done in %.0f s\n", bar->scene, process_now() - bar->started);
}
