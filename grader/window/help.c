#include "window/help.h"

#include "window/keys.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { KEYS_WIDTH = 24, LEAST_MEANING = 32 }; // columns

static const Color white = {255, 255, 255, 255}, dim = {186, 192, 200, 255}, accent = {255, 214, 90, 255};
static const Color ground = {12, 14, 18, 240};

// A row of the table: the keys, and beside or behind them what they do.
static void set_row(Lines *part, int columns, Color color, const char *keys, const char *meaning) {
    static Lines words;
    char line[LINES_LENGTH];
    const bool beside = columns >= KEYS_WIDTH + LEAST_MEANING;
    lines_clear(part);
    lines_clear(&words);
    part->columns = columns;
    words.columns = columns - KEYS_WIDTH;
    if (!beside) {
        snprintf(line, sizeof line, "%s: %s", keys, meaning);
        lines_add(part, color, line);
        return;
    }
    lines_add(&words, color, meaning);
    for (int i = 0; i < words.count; i++) {
        snprintf(line, sizeof line, "%-*s%.200s", KEYS_WIDTH, i ? "" : keys, words.of[i]);
        lines_add(part, color, line);
    }
}

// No row is torn in two.
static int fill(Lines *lines, int rows, int page) {
    static Lines part;
    const char *keys, *meaning;
    int pages = 1, used = 0;
    for (int row = 0; keys_help(row, &keys, &meaning); row++) {
        set_row(&part, lines->columns, row % 2 ? dim : white, keys, meaning);
        if (used > 0 && used + part.count > rows) {
            pages++;
            used = 0;
        }
        used += part.count;
        for (int i = 0; i < part.count && pages == page; i++)
            lines_add(lines, part.colors[i], part.of[i]);
    }
    return pages;
}

int help_page(Lines *lines, int rows, int page) {
    char foot[LINES_LENGTH];
    int pages = fill(lines, rows, page);
    if (pages == 1)
        return 1;
    lines_clear(lines);
    pages = fill(lines, rows - 1, page); // the last one is the foot
    snprintf(foot, sizeof foot, "%d of %d: F1 %s", page, pages, page < pages ? "shows more" : "closes this");
    lines_add(lines, accent, foot);
    return pages;
}

static int lay_out(Lines *lines, const Text *text, int width, int height, int page) {
    lines_clear(lines);
    lines->columns = (int)((float)width / text->advance) - 2;
    return help_page(lines, (int)(((float)height - text->advance) / text->line), page);
}

int help_pages(const Text *text, int width, int height) {
    static Lines lines;
    return lay_out(&lines, text, width, height, 1);
}

void help_put(Text *text, int width, int height, int page) {
    static Lines lines;
    const int pages = lay_out(&lines, text, width, height, page);
    if (page > pages)
        lay_out(&lines, text, width, height, pages);
    const float x = ((float)width - (float)lines.longest * text->advance) / 2 - text->advance;
    lines_put(&lines, text, fmaxf(0, x), fmaxf(0, ((float)height - lines_height(&lines, text)) / 2), ground);
}
