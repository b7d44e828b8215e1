// Splits the text of a table in place: every cell is unquoted where it stands, and rows point into the text.
#include "base/csv.h"

#include "base/csv_write.h"
#include "base/printable.h"
#include "base/text_check.h"
#include "scene/check.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct CsvReader {
    Csv *csv;
    char *at;
    int line; // of `at`
    char separator;
    char *cells[CSV_MAX_COLUMNS]; // of the row that was read last
    int count;
} CsvReader;

// What stands most in the first line, outside of quotes, separates.
static char find_separator(const char *text) {
    static const char candidates[] = ",;\t";
    int counts[3] = {0}, best = 0;
    bool quoted = false;
    for (; *text && (quoted || (*text != '\n' && *text != '\r')); text++) {
        const char *candidate = strchr(candidates, *text);
        quoted = quoted != (*text == '"');
        if (!quoted && candidate)
            counts[candidate - candidates]++;
    }
    for (int i = 1; i < 3; i++)
        best = counts[i] > counts[best] ? i : best;
    return candidates[best];
}

// Some spreadsheets begin with a line "sep=;".
static void take_separator(CsvReader *reader) {
    const bool told = strncmp(reader->at, "sep=", 4) == 0 && strchr(",;\t", reader->at[4]) && reader->at[4];
    reader->at += strspn(reader->at, "\r\n");
    reader->separator = told ? reader->at[4] : find_separator(reader->at);
    for (reader->at += told ? 5 : 0; told && (*reader->at == '\r' || *reader->at == '\n'); reader->at++)
        reader->line += *reader->at == '\n';
}

static bool is_space(const char *at) {
    return *at == ' ' || *at == '\t' || *at == '\n' || *at == '\r';
}

static char *trimmed(char *text) {
    static const char wide[] = "\u00a0"; // as web pages have it
    while (is_space(text) || strncmp(text, wide, 2) == 0)
        text += is_space(text) ? 1 : 2;
    for (size_t length = strlen(text); length > 0; length = strlen(text))
        if (is_space(text + length - 1))
            text[length - 1] = '\0';
        else if (length > 1 && strcmp(text + length - 2, wide) == 0)
            text[length - 2] = '\0';
        else
            break;
    return text[0] == '\'' && csv_is_formula(text + 1) ? text + 1 : text;
}

// Reads what stands in quotes, to `to`, which it returns moved on. NULL with a message when they do not end.
static char *read_quoted(CsvReader *reader, char *to) {
    const int line = reader->line;
    for (reader->at++; *reader->at; reader->at++) {
        if (*reader->at == '"' && reader->at[1] != '"')
            break;
        reader->at += *reader->at == '"';
        reader->line += *reader->at == '\n';
        *to++ = *reader->at;
    }
    if (*reader->at == '"') {
        reader->at++;
        return to;
    }
    check_fail("%s:%d: a quote is opened here and never closed: write \"\" for a quote in a cell",
               reader->csv->path, line);
    return NULL;
}

// Reads a cell and the separator behind it, if there is one: then *more.
static char *read_cell(CsvReader *reader, bool *more) {
    char *cell = reader->at, *to = cell;
    while (*reader->at == ' ')
        reader->at++;
    if (*reader->at == '"' && !(to = read_quoted(reader, to)))
        return NULL;
    while (*reader->at && *reader->at != reader->separator && *reader->at != '\n' && *reader->at != '\r')
        *to++ = *reader->at++;
    *more = *reader->at == reader->separator;
    const char end = *reader->at;
    reader->at += end != '\0';
    if (end == '\r' && *reader->at == '\n')
        reader->at++;
    reader->line += end == '\n' || end == '\r';
    *to = '\0';
    return trimmed(cell);
}

static bool read_row(CsvReader *reader) {
    bool more = true;
    for (reader->count = 0; more; reader->count++) {
        if (reader->count == CSV_MAX_COLUMNS)
            return check_fail("%s:%d: more than %d cells in a row", reader->csv->path, reader->line,
                              CSV_MAX_COLUMNS);
        if (!(reader->cells[reader->count] = read_cell(reader, &more)))
            return false;
    }
    return true;
}

static bool is_empty(const CsvReader *reader) {
    for (int i = 0; i < reader->count; i++)
        if (reader->cells[i][0])
            return false;
    return true;
}

static char **keep_cells(const CsvReader *reader, int count) {
    static char none[] = "";
    char **cells = calloc((size_t)count, sizeof *cells);
    INVARIANT(cells);
    for (int i = 0; i < count; i++)
        cells[i] = i < reader->count ? reader->cells[i] : none;
    return cells;
}

static bool keep_row(const CsvReader *reader, int line) {
    Csv *csv = reader->csv;
    for (int i = csv->column_count; i < reader->count; i++)
        if (reader->cells[i][0])
            return csv->column_count == 1
                       ? check_fail(
                             "%s:%d: %d cells, but the first line has one: remove the lines above that "
                             "with the names of the columns",
                             csv->path, line, reader->count)
                       : check_fail(
                             "%s:%d: %d cells below %d heads: put a cell that holds a separator into quotes",
                             csv->path, line, reader->count, csv->column_count);
    if ((csv->count & (csv->count - 1)) == 0) { // room is always a power of two
        csv->rows = realloc(csv->rows, sizeof *csv->rows * (size_t)(csv->count ? 2 * csv->count : 1));
        INVARIANT(csv->rows);
    }
    csv->rows[csv->count++] = (CsvLine){line, keep_cells(reader, csv->column_count)};
    return true;
}

static bool read_rows(CsvReader *reader) {
    Csv *csv = reader->csv;
    while (*reader->at) {
        const int line = reader->line;
        if (!read_row(reader))
            return false;
        if (is_empty(reader))
            continue;
        if (csv->heads) {
            if (!keep_row(reader, line))
                return false;
        } else {
            csv->heads = keep_cells(reader, reader->count);
            csv->column_count = reader->count;
        }
    }
    return csv->heads ||
           check_fail("%s:1: the file is empty: its first line must name the columns", csv->path);
}

static bool is_utf8(const Csv *csv) {
    const size_t good = printable_utf8(csv->text);
    int line = 1;
    for (size_t i = 0; i < good; i++)
        line += csv->text[i] == '\n';
    return !csv->text[good] ||
           check_fail("%s:%d: the text is not UTF-8: save it as \"CSV UTF-8\"", csv->path, line);
}

bool csv_read(Csv *csv, const char *path) {
    size_t size;
    *csv = (Csv){0};
    snprintf(csv->path, sizeof csv->path, "%s", path);
    csv->text = files_read_bytes(path, CSV_MAX_BYTES, &size);
    bool ok = csv->text && text_check(csv->text, size, path) && is_utf8(csv);
    CsvReader *reader = ok ? calloc(1, sizeof *reader) : NULL;
    if (reader) {
        *reader = (CsvReader){.csv = csv, .at = csv->text, .line = 1};
        take_separator(reader);
        ok = read_rows(reader);
    }
    free(reader);
    if (!ok)
        csv_destroy(csv);
    return ok;
}

void csv_destroy(Csv *csv) {
    for (int i = 0; i < csv->count; i++)
        free(csv->rows[i].cells);
    free(csv->rows);
    free(csv->heads);
    free(csv->text);
    *csv = (Csv){0};
}

static bool same_head(const char *head, const char *name) {
    for (;; head++) {
        const unsigned char c = (unsigned char)*head;
        if (c && c < 0x80 && !isalnum(c))
            continue;
        while (*name && (unsigned char)*name < 0x80 && !isalnum((unsigned char)*name))
            name++;
        if (tolower(c) != tolower((unsigned char)*name) || !c)
            return !c && !*name;
        name++;
    }
}

int csv_column(const Csv *csv, const char *const *names) {
    for (; *names; names++)
        for (int i = 0; i < csv->column_count; i++)
            if (same_head(csv->heads[i], *names))
                return i;
    return -1;
}

bool csv_named_once(const Csv *csv, int column) {
    for (int i = 0; column >= 0 && i < csv->column_count; i++)
        if (i != column && same_head(csv->heads[i], csv->heads[column]))
            return csv_fail(csv, -1,
                            "two columns are named \"%.60s\" (columns %d and %d): rename the one that does "
                            "not count, or remove it",
                            csv->heads[column], column < i ? column + 1 : i + 1,
                            column < i ? i + 1 : column + 1);
    return true;
}

const char *csv_cell(const Csv *csv, int row, int column) {
    return column < 0 ? "" : csv->rows[row].cells[column];
}

bool csv_fail(const Csv *csv, int row, const char *format, ...) {
    char text[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    for (char *at = text; *at; at++) // control characters could write anything to a terminal
        if ((unsigned char)*at < ' ' || *at == 0x7f)
            *at = '?';
    return check_fail("%s:%d: %s", csv->path, row < 0 ? 1 : csv->rows[row].line, text);
}
