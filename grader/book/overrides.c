// Finds the columns, reads each row, and refuses what stands there twice.
#include "book/overrides.h"

#include "base/option_values.h"
#include "intake/lab_name.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { MOST_POINTS = 1000, MOST_DAYS = 366 };

typedef struct OverrideColumns {
    int student, lab, check, points, late, note;
} OverrideColumns;

static bool find_columns(OverrideColumns *columns, const Csv *csv) {
    *columns =
        (OverrideColumns){.student = csv_column(csv, (const char *const[]){"student", "id", "submission",
                                                                           "name", "mail", "email", NULL}),
                          .lab = csv_column(csv, (const char *const[]){"lab", NULL}),
                          .check = csv_column(csv, (const char *const[]){"check", "checks", NULL}),
                          .points = csv_column(csv, (const char *const[]){"points", "score", NULL}),
                          .late = csv_column(csv, (const char *const[]){"late", "late days", NULL}),
                          .note = csv_column(csv, (const char *const[]){"note", "reason", "why", NULL})};
    const char *missing = columns->student < 0                       ? "student"
                          : columns->lab < 0                         ? "lab"
                          : columns->note < 0                        ? "note"
                          : columns->points < 0 && columns->late < 0 ? "points"
                                                                     : NULL;
    const int used[] = {columns->student, columns->lab,  columns->check,
                        columns->points,  columns->late, columns->note};
    for (size_t i = 0; i < sizeof used / sizeof used[0]; i++)
        if (!csv_named_once(csv, used[i]))
            return false;
    return !missing || csv_fail(csv, -1,
                                "the column %s is missing: the first line must be "
                                "student,lab,points,note, with check or late as you need them",
                                missing);
}

// "85.5", and "85,5" where the semicolon separates.
static bool read_number(double *number, const char *text, double most) {
    char plain[32];
    snprintf(plain, sizeof plain, "%s", text);
    for (char *comma; (comma = strchr(plain, ','));)
        *comma = '.';
    const bool ok =
        strlen(text) < sizeof plain && option_decimal(number, plain) && *number >= 0 && *number <= most;
    check_clear();
    return ok;
}

static bool read_lab(char lab[3], const char *text) {
    const bool number = text[0] && strlen(text) <= 2 && !text[strspn(text, "0123456789")];
    if (number)
        snprintf(lab, 3, "%02d", atoi(text));
    return number || lab_name_find(lab, text);
}

static bool read_row(Overrides *overrides, int row, const OverrideColumns *columns) {
    const Csv *csv = &overrides->csv;
    const char *points = csv_cell(csv, row, columns->points), *late = csv_cell(csv, row, columns->late);
    Override *override = &overrides->list[overrides->count++];
    double days = OVERRIDE_NONE;
    *override = (Override){.row = row,
                           .student = csv_cell(csv, row, columns->student),
                           .check = csv_cell(csv, row, columns->check),
                           .points = OVERRIDE_NONE,
                           .note = csv_cell(csv, row, columns->note)};
    if (!override->student[0])
        return csv_fail(csv, row, "student is empty: write a number, mail or name");
    if (!read_lab(override->lab, csv_cell(csv, row, columns->lab)))
        return csv_fail(csv, row, "\"%.40s\" is no lab: write its number, as 03",
                        csv_cell(csv, row, columns->lab));
    if (points[0] && !read_number(&override->points, points, MOST_POINTS))
        return csv_fail(csv, row, "\"%.40s\" are no points: write a number from 0 to %d", points,
                        MOST_POINTS);
    if (late[0] && !(read_number(&days, late, MOST_DAYS) && days == (int)days))
        return csv_fail(csv, row, "\"%.40s\" are no days: write a whole number from 0 to %d", late,
                        MOST_DAYS);
    override->late_days = (int)days;
    if (!points[0] && !late[0])
        return csv_fail(csv, row, "neither points nor late days are given: write one, or remove the row");
    if (late[0] && override->check[0])
        return csv_fail(csv, row, "a check is not late: write the days in a row without a check");
    return override->note[0] || csv_fail(csv, row, "the note is empty: say why");
}

// The same thing twice is a slip: nobody knows which one counts.
static bool are_once(const Overrides *overrides) {
    for (int i = 0; i < overrides->count; i++)
        for (int j = 0; j < i; j++) {
            const Override *a = &overrides->list[j], *b = &overrides->list[i];
            INVARIANT(a->student && b->student && a->check && b->check); // read_row has set them
            const bool both = (a->points >= 0 && b->points >= 0) || (a->late_days >= 0 && b->late_days >= 0);
            if (both && strcmp(a->lab, b->lab) == 0 && strcasecmp(a->student, b->student) == 0 &&
                strcasecmp(a->check, b->check) == 0)
                return csv_fail(&overrides->csv, b->row,
                                "the same stands already in line %d: keep one of them",
                                overrides->csv.rows[a->row].line);
        }
    return true;
}

bool overrides_read(Overrides *overrides, const char *path) {
    OverrideColumns columns;
    *overrides = (Overrides){0};
    bool ok = csv_read(&overrides->csv, path) && find_columns(&columns, &overrides->csv);
    overrides->list = calloc((size_t)overrides->csv.count + 1, sizeof *overrides->list);
    INVARIANT(overrides->list);
    for (int row = 0; ok && overrides->list && row < overrides->csv.count; row++)
        ok = read_row(overrides, row, &columns);
    if (ok && are_once(overrides))
        return true;
    overrides_destroy(overrides);
    return false;
}

void overrides_destroy(Overrides *overrides) {
    free(overrides->list);
    csv_destroy(&overrides->csv);
    *overrides = (Overrides){0};
}
