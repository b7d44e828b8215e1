#include "class/ticker.h"

#include "base/process.h"

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

static void print_bar(const Ticker *ticker) {
    double seconds = process_now() - ticker->start;
    int now = ticker->finished - ticker->earlier, left = ticker->total - ticker->finished;
    fputs("\r\033[K[", ticker->out);
    for (int i = 0; i < BAR; i++)
        fputc(i < BAR * ticker->finished / ticker->total ? '#' : '.', ticker->out);
    fprintf(ticker->out, "] %d of %d", ticker->finished, ticker->total);
    if (now > 0 && seconds > 0) {
        fprintf(ticker->out, ", %.0f a minute, ", 60 * now / seconds);
        print_time(ticker->out, left * seconds / now);
        fputs(" left", ticker->out);
    }
    if (ticker->failed)
        fprintf(ticker->out, ", %d not graded", ticker->failed);
    fflush(ticker->out);
}

void ticker_begin(Ticker *ticker, FILE *out, int total, int earlier) {
    *ticker = (Ticker){.out = out,
                       .bar = isatty(fileno(out)),
                       .total = total,
                       .finished = earlier,
                       .earlier = earlier,
                       .start = process_now()};
    if (earlier)
        fprintf(out, "%d of %d were graded before\n", earlier, total);
    if (ticker->bar && total > earlier)
        print_bar(ticker);
}

void ticker_step(Ticker *ticker, const char *name, const char *result, bool failed) {
    ticker->finished++;
    ticker->failed += failed;
    if (ticker->bar && failed)
        fprintf(ticker->out, "\r\033[K%s: %s\n", name, result);
    if (ticker->bar)
        print_bar(ticker);
    else
        fprintf(ticker->out, "%d/%d %s: %s\n", ticker->finished, ticker->total, name, result);
    fflush(ticker->out);
}

void ticker_end(const Ticker *ticker) {
    if (ticker->bar && ticker->finished > ticker->earlier)
        fputc('\n', ticker->out);
}
