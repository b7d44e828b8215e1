#include "base/progress_bar.h"

#include "base/process.h"

#include <unistd.h>

enum { WIDTH = 24 };

static void print_time(FILE *out, double seconds) {
    if (seconds >= 5400)
        fprintf(out, "%.1f h", seconds / 3600);
    else if (seconds >= 90)
        fprintf(out, "%.0f min", seconds / 60);
    else
        fprintf(out, "%.0f s", seconds);
}

static void print_bar(const ProgressBar *bar) {
    double seconds = process_now() - bar->start;
    int now = bar->done - bar->earlier, left = bar->total - bar->done;
    fprintf(bar->out, "\r\033[K%s [", bar->label);
    for (int i = 0; i < WIDTH; i++)
        fputc(i < WIDTH * bar->done / bar->total ? '#' : '.', bar->out);
    fprintf(bar->out, "] %d of %d", bar->done, bar->total);
    if (now > 0 && seconds > 0) {
        fprintf(bar->out, ", %.0f a minute, ", 60 * now / seconds);
        print_time(bar->out, left * seconds / now);
        fputs(" left", bar->out);
    }
    if (bar->failed)
        fprintf(bar->out, ", %d failed", bar->failed);
    fflush(bar->out);
}

void progress_bar_begin(ProgressBar *bar, FILE *out, const char *label, int total, int earlier) {
    *bar = (ProgressBar){.out = out,
                         .label = label,
                         .terminal = isatty(fileno(out)),
                         .total = total,
                         .done = earlier,
                         .earlier = earlier,
                         .start = process_now()};
    if (earlier || !bar->terminal)
        fprintf(out, "%s: %d to do, %d done before\n", label, total - earlier, earlier);
    if (bar->terminal && total > earlier)
        print_bar(bar);
}

void progress_bar_step(ProgressBar *bar, const char *line, bool failed) {
    bar->done++;
    bar->failed += failed;
    if (bar->terminal && line && failed)
        fprintf(bar->out, "\r\033[K%s\n", line);
    if (bar->terminal)
        print_bar(bar);
    else if (line)
        fprintf(bar->out, "%d/%d %s\n", bar->done, bar->total, line);
    fflush(bar->out);
}

double progress_bar_end(const ProgressBar *bar) {
    if (bar->terminal)
        fputs("\r\033[K", bar->out);
    return process_now() - bar->start;
}
