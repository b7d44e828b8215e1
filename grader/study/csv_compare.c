// Reads two tables of a study and tells the settings that only one has on its front, and whether the bars
// explain it.
#include "study/csv.h"

#include "scene/check.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 8 * METHOD_MOST, NAME = 160, COLUMNS = 27, BEFORE_TIMES = 5, BEFORE_ERRORS = 12 };

typedef struct CsvRow {
    char scene[32], name[NAME]; // name: scene, lab, whose, method and setting
    Point point;
} CsvRow;

typedef struct CsvTable {
    CsvRow rows[MOST];
    int count;
} CsvTable;

// Cuts the line at its commas outside quotes, which go; false when it has another number of fields.
static bool split(char *line, char *fields[COLUMNS]) {
    int count = 0;
    for (char *at = line; at; count++) {
        bool is_quoted = *at == '"';
        char *end = is_quoted ? strchr(at + 1, '"') : at + strcspn(at, ",");
        if (!end || count == COLUMNS || (is_quoted && end[1] != ',' && end[1] != '\0'))
            return false;
        fields[count] = at + is_quoted;
        char *comma = end + is_quoted;
        at = *comma ? comma + 1 : NULL;
        *end = *comma = '\0';
    }
    return count == COLUMNS;
}

static bool take(CsvTable *table, char *line) {
    char *fields[COLUMNS];
    if (!split(line, fields) || table->count == MOST)
        return false;
    CsvRow *row = &table->rows[table->count++];
    *row = (CsvRow){.point = {.ms = atof(fields[BEFORE_TIMES + 1]),
                              .mad = atof(fields[BEFORE_TIMES + 2]),
                              .error = atof(fields[BEFORE_ERRORS]),
                              .on_front = atoi(fields[COLUMNS - 3]) != 0}};
    snprintf(row->scene, sizeof row->scene, "%s", fields[0]);
    for (int i = 0; i < BEFORE_TIMES; i++)
        check_append(row->name, sizeof row->name, "%s%s", i ? ", " : "", fields[i]);
    return true;
}

static bool read_table(CsvTable *table, const char *path) {
    char line[1024];
    int number = 0;
    FILE *file = fopen(path, "r");
    if (!file)
        return check_fail("%s: %s", path, strerror(errno));
    bool ok = true;
    while (ok && fgets(line, sizeof line, file)) {
        line[strcspn(line, "\r\n")] = '\0';
        ok = number++ == 0 ? strncmp(line, "scene,lab,", 10) == 0 : take(table, line);
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
        if (!before || strcmp(rival->scene, off->scene) != 0 || !pareto_dominates(&rival->point, &off->point))
            continue;
        if (!pareto_bars_overlap(&rival->point, &off->point) &&
            !pareto_bars_overlap(&before->point, &on->point))
            return false;
    }
    return true;
}

bool csv_compare(const char *a, const char *b, FILE *out, int *unexplained) {
    static CsvTable first, second;
    int both = 0, swapped = 0, front = 0;
    *unexplained = first.count = second.count = 0;
    if (!read_table(&first, a) || !read_table(&second, b))
        return false;
    for (int i = 0; i < first.count; i++) {
        const CsvRow *x = &first.rows[i], *y = find(&second, x);
        if (!y)
            continue;
        both++;
        front += x->point.on_front && y->point.on_front;
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
    return true;
}
