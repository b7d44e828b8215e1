#include "points/own_table.h"

#include "scene/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct Columns {
    int title, method, setting, whose, ms, error, message;
} Columns;

static int column(const Csv *csv, const char *name) {
    return csv_column(csv, (const char *const[]){name, NULL});
}

static bool find_columns(const Csv *csv, Columns *at) {
    *at = (Columns){column(csv, "title"), column(csv, "method"), column(csv, "setting"), column(csv, "whose"),
                    column(csv, "ms"),    column(csv, "error"),  column(csv, "message")};
    return (at->title >= 0 && at->method >= 0 && at->setting >= 0 && at->whose >= 0 && at->ms >= 0 &&
            at->error >= 0 && at->message >= 0) ||
           csv_fail(csv, -1, "this is no table of make study: measure again");
}

static bool take_number(const char *cell, double *number) {
    char *end;
    *number = strtod(cell, &end);
    return end != cell && *end == '\0' && isfinite(*number) && *number >= 0;
}

static bool same(const Csv *csv, int a, int b, int at) {
    return strcmp(csv_cell(csv, a, at), csv_cell(csv, b, at)) == 0;
}

// Ours stands in the row before the student's.
static bool take_row(const Csv *csv, const Columns *at, int i, OwnRow *row) {
    *row = (OwnRow){
        .title = csv_cell(csv, i, at->title),
        .method = csv_cell(csv, i, at->method),
        .setting = csv_cell(csv, i, at->setting),
    };
    return i > 0 && strcmp(csv_cell(csv, i, at->whose), "yours") == 0 &&
           strcmp(csv_cell(csv, i - 1, at->whose), "recorded") == 0 && same(csv, i - 1, i, at->title) &&
           same(csv, i - 1, i, at->method) && same(csv, i - 1, i, at->setting) &&
           !csv_cell(csv, i, at->message)[0] && take_number(csv_cell(csv, i, at->ms), &row->milliseconds) &&
           row->milliseconds > 0 && take_number(csv_cell(csv, i, at->error), &row->error) &&
           take_number(csv_cell(csv, i - 1, at->ms), &row->our_milliseconds) &&
           take_number(csv_cell(csv, i - 1, at->error), &row->our_error);
}

bool own_table_read(OwnTable *table, const char *path) {
    Columns at;
    *table = (OwnTable){0};
    if (!csv_read(&table->csv, path) || !find_columns(&table->csv, &at)) {
        own_table_destroy(table);
        return false;
    }
    table->rows = calloc((size_t)table->csv.count + 1, sizeof *table->rows);
    INVARIANT(table->rows);
    for (int i = 0; i < table->csv.count; i++)
        table->count += take_row(&table->csv, &at, i, &table->rows[table->count]);
    return true;
}

void own_table_destroy(OwnTable *table) {
    free(table->rows);
    csv_destroy(&table->csv);
    *table = (OwnTable){0};
}

int own_table_next_scene(const OwnTable *table, int row) {
    int next = row;
    while (next < table->count && strcmp(table->rows[next].title, table->rows[row].title) == 0)
        next++;
    return next;
}

int own_table_best(const OwnTable *table, int row) {
    int best = row;
    for (int i = row; i < own_table_next_scene(table, row); i++) {
        const OwnRow *now = &table->rows[i], *least = &table->rows[best];
        if (now->error < least->error ||
            (now->error == least->error && now->milliseconds < least->milliseconds))
            best = i;
    }
    return best;
}

int own_table_quicker(const OwnTable *table, int row, int best) {
    int quicker = -1;
    for (int i = row; i < own_table_next_scene(table, row); i++)
        if (2 * table->rows[i].our_milliseconds <= table->rows[best].milliseconds &&
            (quicker < 0 || table->rows[i].our_error < table->rows[quicker].our_error))
            quicker = i;
    return quicker;
}
