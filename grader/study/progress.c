#include "progress.h"

#include "process.h"

#include <stdio.h>
#include <unistd.h>

enum { WIDTH = 30 };

static void show(Progress *progress) {
    int percent = progress->all > 0 ? 100 * progress->done / progress->all : 100;
    if (!progress->terminal || percent == progress->shown)
        return;
    progress->shown = percent;
    int steps = progress->done - progress->began;
    double passed = process_now() - progress->started;
    double left = steps > 0 ? passed / steps * (progress->all - progress->done) : 0;
    fprintf(stderr, "\r%-10s [", progress->scene);
    for (int i = 0; i < WIDTH; i++)
        fputc(i < percent * WIDTH / 100 ? '#' : ' ', stderr);
    fprintf(stderr, "] %3d %%, %3.0f s left ", percent, left);
}

void progress_begin(Progress *progress, const char *scene, int done, int all) {
    *progress = (Progress){.terminal = isatty(STDERR_FILENO),
                           .started = process_now(),
                           .scene = scene,
                           .done = done,
                           .all = all,
                           .began = done,
                           .shown = -1};
    if (!progress->terminal)
        fprintf(stderr, "%s: %d steps, %d of them done before\n", scene, all, done);
    show(progress);
}

void progress_step(Progress *progress) {
    progress->done++;
    show(progress);
}

void progress_end(Progress *progress) {
    if (progress->terminal)
        fprintf(stderr, "\r%-79s\r", "");
    fprintf(stderr, "%s: done in %.0f s\n", progress->scene, process_now() - progress->started);
}
