// Adds lines, wraps them at words, and prints them within the columns and rows there are.
#include "watch/sheet.h"

#include "base/printable.h"

#include <stdarg.h>
#include <string.h>

void sheet_begin(Sheet *sheet, int columns) {
    sheet->columns = columns < SHEET_WIDTH ? columns : SHEET_WIDTH - 1;
    sheet->count = 0;
}

static PageLine *add(Sheet *sheet, Style style) {
    static PageLine spare; // takes what has no room
    PageLine *line = sheet->count < SHEET_LINES ? &sheet->lines[sheet->count++] : &spare;
    *line = (PageLine){.style = style};
    return line;
}

void sheet_line(Sheet *sheet, Style style, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    PageLine *line = add(sheet, style);
    vsnprintf(line->text, sizeof line->text, format, arguments);
    va_end(arguments);
}

void sheet_marked(Sheet *sheet, Style mark_style, const char *mark, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    PageLine *line = add(sheet, STYLE_PLAIN);
    line->mark_style = mark_style;
    snprintf(line->mark, sizeof line->mark, "%s", mark);
    vsnprintf(line->text, sizeof line->text, format, arguments);
    va_end(arguments);
}

// How many bytes of `text` (without its line's end) go on a line of `width` characters: up to the last space
// that fits, or, with none, `width`.
static int break_at(const char *text, int width) {
    const int length = (int)strcspn(text, "\n"), fitting = (int)printable_clip(text, width);
    if (length <= fitting)
        return length;
    int at = fitting;
    while (at > 0 && text[at] != ' ')
        at--;
    return at > 0 ? at : fitting;
}

// An item of a list goes on below its words, and not below its dash.
static int hang(const char *text) {
    return strncmp(text, "- ", 2) == 0 ? 2 : 0;
}

void sheet_text(Sheet *sheet, Style style, int indent, const char *text) {
    int first = indent, rest = indent + hang(text);
    while (*text) {
        const int width = sheet->columns - first > 20 ? sheet->columns - first : 20;
        const int length = break_at(text, width);
        sheet_line(sheet, style, "%*s%.*s", first, "", length, text);
        text += length;
        first = rest;
        if (*text == '\n') {
            first = indent;
            rest = indent + hang(text + 1);
        }
        text += *text == ' ' || *text == '\n';
    }
}

void sheet_wrapped(Sheet *sheet, Style style, int indent, const char *format, ...) {
    char text[SHEET_WIDTH];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    sheet_text(sheet, style, indent, text);
}

void sheet_bar(char *text, size_t size, double share, int width) {
    const int full = (int)(share * width + 1e-9);
    int used = snprintf(text, size, "[");
    for (int i = 0; i < width && used < (int)size - 2; i++)
        text[used++] = i < full ? '#' : '.';
    snprintf(text + used, size - (size_t)used, "]");
}

static void put_text(FILE *out, Style style, const char *text, int width, bool color) {
    const bool styled = color && style != STYLE_PLAIN;
    fprintf(out, "%s%.*s%s", styled ? color_begin((ColorUse)style) : "", (int)printable_clip(text, width),
            text, styled ? COLOR_END : "");
}

static void put_line(FILE *out, const PageLine *line, int columns, bool color) {
    const int mark = (int)strlen(line->mark) < columns ? (int)strlen(line->mark) : columns;
    put_text(out, line->mark_style, line->mark, mark, color);
    put_text(out, line->style, line->text, columns - mark, color);
}

void sheet_print(const Sheet *sheet, FILE *out, bool color) {
    for (int i = 0; i < sheet->count; i++) {
        put_line(out, &sheet->lines[i], SHEET_WIDTH, color);
        fputc('\n', out);
    }
    fflush(out);
}

int sheet_last_top(const Sheet *sheet, int rows) {
    return sheet->count > rows - 1 ? sheet->count - (rows - 1) : 0;
}

int sheet_top_with(const Sheet *sheet, int line, int top, int rows) {
    const int seen = rows - 2 > 1 ? rows - 2 : 1, last = sheet_last_top(sheet, rows); // one row tells of more
    const int least = line - seen + 1 > 0 ? line - seen + 1 : 0;
    const int wanted = line < top ? line : top < least ? least : top;
    return wanted < last ? wanted : last;
}

// One write, from the top, without clearing first: nothing flickers.
void sheet_show(const Sheet *sheet, int top, const char *footer, int columns, int rows, bool color) {
    static char buffer[SHEET_LINES * (SHEET_WIDTH + 64)];
    FILE *out = fmemopen(buffer, sizeof buffer, "w");
    const int room = rows - 1, left = sheet->count - top, shown = left <= room ? left : room - 1;
    if (!out)
        return;
    fputs("\033[H", out);
    for (int i = 0; i < room; i++) {
        if (i < shown)
            put_line(out, &sheet->lines[top + i], columns, color);
        else if (i == shown && shown < left)
            put_text(out, STYLE_DIM, "... (down, or a larger window shows more)", columns, color);
        fputs("\033[K\r\n", out);
    }
    put_text(out, STYLE_DIM, footer, columns - 1, color);
    fputs("\033[K", out);
    fclose(out);
    fputs(buffer, stdout);
    fflush(stdout);
}
