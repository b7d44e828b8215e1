// Reads two tables of a study and tells the settings that only one has on its front, and whether the bars
// explain it.
#include "study/findings_csv.h"

#include "scene/check.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 16 * METHOD_MOST, NAME = 160, COLUMNS = 64, NAMES = 5 };

typedef struct CsvRow {
    char scene[32], name[NAME]; // name: scene, lab, whose, method and setting
    Point point;
    bool chosen;
} CsvRow;

// Where a table has its columns; -1: it has no such one.
typedef struct CsvColumns {
    int count, ms, mad, error, on_front, chosen;
} CsvColumns;

typedef struct CsvTable {
    CsvRow rows[MOST];
    int count;
    CsvColumns columns;
} CsvTable;

// Cuts the line at its commas outside quotes, which go. The number of fields; 0 when there are too many or a
// quote does not end.
static int split(char *line, char *fields[COLUMNS]) {
    int count = 0;
    for (char *at = line; at; count++) {
        bool is_quoted = *at == '"';
        char *end = is_quoted ? strchr(at + 1, '"') : at + strcspn(at, ",");
        if (!end || count == COLUMNS || (is_quoted && end[1] != ',' && end[1] != '\0'))
            return 0;
        fields[count] = at + is_quoted;
        char *comma = end + is_quoted;
        at = *comma ? comma + 1 : NULL;
        *end = *comma = '\0';
    }
    return count;
}

static int column(char *fields[COLUMNS], int count, const char *name) {
    for (int i = 0; i < count; i++)
        if (strcmp(fields[i], name) == 0)
            return i;
    return -1;
}

static bool take_head(CsvTable *table, char *line) {
    char *fields[COLUMNS];
    int count = split(line, fields);
    CsvColumns *at = &table->columns;
    *at = (CsvColumns){.count = count,
                       .ms = column(fields, count, "ms"),
                       .mad = column(fields, count, "ms_mad"),
                       .error = column(fields, count, "error"),
                       .on_front = column(fields, count, "on_front"),
                       .chosen = column(fields, count, "chosen")};
    return column(fields, count, "setting") == NAMES - 1 && at->ms >= NAMES && at->mad >= NAMES &&
           at->error >= NAMES && at->on_front >= NAMES && at->chosen >= NAMES;
}

static bool take(CsvTable *table, char *line) {
    char *fields[COLUMNS];
    const CsvColumns *at = &table->columns;
    if (split(line, fields) != at->count || table->count == MOST)
        return false;
    CsvRow *row = &table->rows[table->count++];
    *row = (CsvRow){
        .point = {.ms = atof(fields[at->ms]),
                  .mad = atof(fields[at->mad]),
                  .error = atof(fields[at->error]),
                  .on_front = atoi(fields[at->on_front]) != 0,
                  .aside = strcmp(fields[1], METHOD_RAYS) == 0 || strcmp(fields[3], METHOD_BARE) == 0},
        .chosen = atoi(fields[at->chosen]) != 0};
    snprintf(row->scene, sizeof row->scene, "%s", fields[0]);
    for (int i = 0; i < NAMES; i++)
        check_append(row->name, sizeof row->name, "%s%s", i ? ", " : "", fields[i]);
    return true;
}

static bool read_table(CsvTable *table, const char *path) {
    char line[2048];
    int number = 0;
    FILE *file = fopen(path, "r");
    if (!file)
        return check_fail("%s: %s", path, strerror(errno));
    bool ok = true;
    while (ok && fgets(line, sizeof line, file)) {
        line[strcspn(line, "\r\n")] = '\0';
        ok = number++ == 0 ? take_head(table, line) : take(table, line);
    }
    fclose(file);
    if (ok && number > 0)
        return true;
    return check_fail("%s:%d: not a chart.csv of this version; make it again with make study", path, number);
}

static const CsvRow *find(const CsvTable *table, const CsvRow *wanted) {
    for (int i = 0; i < table->count; i++)
        if (strcmp(table->rows[i].name, wanted->name) == 0)
            return &table->rows[i];
    return NULL;
}

// Does noise explain that `on` is on the front of its table and `off` not on that of the other? For each one
// that dominates it in the other table only.
static bool is_explained(const CsvTable *on_table, const CsvRow *on, const CsvTable *off_table,
                         const CsvRow *off) {
    for (int i = 0; i < off_table->count; i++) {
        const CsvRow *rival = &off_table->rows[i], *before = find(on_table, rival);
        if (!before || rival->point.aside || strcmp(rival->scene, off->scene) != 0 ||
            !pareto_dominates(&rival->point, &off->point))
            continue;
        if (!pareto_bars_overlap(&rival->point, &off->point) &&
            !pareto_bars_overlap(&before->point, &on->point))
            return false;
    }
    return true;
}

bool findings_csv_compare(const char *a, const char *b, FILE *out, int *unexplained) {
    static CsvTable first, second;
    int both = 0, swapped = 0, front = 0, needs = 0, same = 0;
    *unexplained = first.count = second.count = 0;
    if (!read_table(&first, a) || !read_table(&second, b))
        return false;
    for (int i = 0; i < first.count; i++) {
        const CsvRow *x = &first.rows[i], *y = find(&second, x);
        if (!y)
            continue;
        both++;
        front += x->point.on_front && y->point.on_front;
        needs += x->chosen;
        same += x->chosen && y->chosen;
        if (x->chosen != y->chosen)
            fprintf(out, "%s: what its scene needs by %s only\n", x->name, x->chosen ? a : b);
        if (x->point.on_front == y->point.on_front)
            continue;
        bool explained =
            x->point.on_front ? is_explained(&first, x, &second, y) : is_explained(&second, y, &first, x);
        fprintf(out, "%s: on the front of %s only; %s\n", x->name, x->point.on_front ? a : b,
                explained ? "within the error bars" : "NOT explained by the error bars");
        swapped++;
        *unexplained += !explained;
    }
    fprintf(out, "%d settings in both, %d on both fronts, %d swapped, %d of these outside the error bars\n",
            both, front, swapped, *unexplained);
    fprintf(out, "%d scenes have a setting that they need; both name the same for %d of them\n", needs, same);
    return true;
}
