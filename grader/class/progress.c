#include "progress.h"

#include "process.h"

#include <stdlib.h>
#include <unistd.h>

enum { BAR = 24 };

static void print_time(FILE *out, double seconds) {
    if (seconds >= 5400)
        fprintf(out, "%.1f h", seconds / 3600);
    else if (seconds >= 90)
        fprintf(out, "%.0f min", seconds / 60);
    else
        fprintf(out, "%.0f s", seconds);
}

static void print_bar(const Progress *progress) {
    double seconds = process_now() - progress->start;
    int now = progress->finished - progress->earlier, left = progress->total - progress->finished;
    fputs("\r\033[K[", progress->out);
    for (int i = 0; i < BAR; i++)
        fputc(i < BAR * progress->finished / progress->total ? '#' : '.', progress->out);
    fprintf(progress->out, "] %d of %d", progress->finished, progress->total);
    if (now > 0 && seconds > 0) {
        fprintf(progress->out, ", %.0f a minute, ", 60 * now / seconds);
        print_time(progress->out, left * seconds / now);
        fputs(" left", progress->out);
    }
    if (progress->failed)
        fprintf(progress->out, ", %d not graded", progress->failed);
    fflush(progress->out);
}

void progress_begin(Progress *progress, FILE *out, int total, int earlier) {
    *progress = (Progress){.out = out,
                           .bar = isatty(fileno(out)),
                           .total = total,
                           .finished = earlier,
                           .earlier = earlier,
                           .start = process_now()};
    if (earlier)
        fprintf(out, "%d of %d were graded before\n", earlier, total);
    if (progress->bar && total > earlier)
        print_bar(progress);
}

void progress_step(Progress *progress, const char *name, const char *result, bool failed) {
    progress->finished++;
    progress->failed += failed;
    if (progress->bar && failed)
        fprintf(progress->out, "\r\033[K%s: %s\n", name, result);
    if (progress->bar)
        print_bar(progress);
    else
        fprintf(progress->out, "%d/%d %s: %s\n", progress->finished, progress->total, name, result);
    fflush(progress->out);
}

void progress_end(const Progress *progress) {
    if (progress->bar && progress->finished > progress->earlier)
        fputc('\n', progress->out);
}
