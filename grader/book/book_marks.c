// Fills in each mark in the order: measured, days late, points that they take, points by hand.
#include "book/book_marks.h"

#include "scene/check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

static void measure(const Book *book, BookRow *row) {
    for (int n = 0; row->entry >= 0 && n < book->table->plan->lab_count; n++) {
        const json_t *lab = table_lab(book->table, row->entry, n);
        if (!table_is_graded(book->table, row->entry) || !lab)
            continue;
        BookMark *mark = &row->marks[n];
        *mark = (BookMark){.measured = true,
                           .handed_in = !json_is_false(json_object_get(lab, "handed_in")),
                           .known = true,
                           .score = table_number(lab, "score"),
                           .maximum = table_number(lab, "max_score")};
        mark->points = mark->score;
    }
}

static int lab_number(const Book *book, const char *lab) {
    for (int n = 0; n < book->table->plan->lab_count; n++)
        if (strcmp(book->table->plan->labs[n], lab) == 0)
            return n;
    return BOOK_NONE;
}

// The days that the clock gives to each lab.
static void count_days(const Book *book, BookRow *row) {
    BookClock clock;
    const time_t time = book_time(book, row, &clock);
    for (int n = 0; n < book->table->plan->lab_count; n++)
        if (row->marks[n].handed_in)
            row->marks[n].late_days = late_rule_days(&book->late, book->table->plan->labs[n], time);
}

// Takes points for the days, the free ones first, in the order of the due dates.
static void take_days(const Book *book, BookRow *row) {
    char text[200];
    BookClock clock;
    int left = book->late.free_days;
    book_time(book, row, &clock);
    for (int i = 0; i < book->late.count; i++) {
        const int n = lab_number(book, book->late.labs[i]);
        if (n < 0 || row->marks[n].late_days == 0)
            continue;
        BookMark *mark = &row->marks[n];
        mark->free_days = mark->late_days < left ? mark->late_days : left;
        left -= mark->free_days;
        mark->taken =
            round(100 * mark->score * late_rule_share(&book->late, mark->late_days - mark->free_days)) / 100;
        mark->points = mark->score - mark->taken;
        snprintf(text, sizeof text, "lab %s: %d day%s late%s, %d of them free: %.2f points off",
                 book->late.labs[i], mark->late_days, mark->late_days == 1 ? "" : "s",
                 clock == CLOCK_FILES && !mark->days_given ? " by the files' times" : "", mark->free_days,
                 mark->taken);
        book_note(row, text);
    }
}

static bool is_named(const Book *book, const BookRow *row, const char *name) {
    if (row->entry < 0)
        return false;
    const RosterEntry *entry = &book->table->roster->entries[row->entry];
    return strcmp(entry->name, name) == 0 || strcmp(entry->shown, name) == 0 ||
           strcmp(entry->file, name) == 0 || strcmp(entry->student, name) == 0 ||
           (entry->id[0] && strcmp(entry->id, name) == 0);
}

static bool override_fail(const Book *book, const Override *override, const char *what, const char *name,
                          const char *remedy) {
    return csv_fail(&book->overrides.csv, override->row, "%s \"%.60s\": %s", what, name, remedy);
}

// The row of the student that an override names.
static BookRow *find_row(Book *book, const Override *override) {
    const int student =
        book->listed ? student_list_find(&book->list, override->student, override->student) : BOOK_NONE;
    BookRow *found = NULL;
    int count = 0;
    for (int r = 0; r < book->count; r++) {
        BookRow *row = &book->rows[r];
        if ((student >= 0 && row->student == student) || is_named(book, row, override->student)) {
            found = row;
            count++;
        }
    }
    if (count != 1)
        override_fail(book, override, count ? "several rows are those of" : "there is no student",
                      override->student,
                      "write a number of the roster, or a submission as grades.csv has it");
    return count == 1 ? found : NULL;
}

// The points of a check, as they were measured; below 0 when the lab has none of this name.
static double check_points(const json_t *lab, const char *name, double *most) {
    size_t i;
    const json_t *check;
    json_array_foreach(json_object_get(lab, "checks"), i,
                       check) if (strcasecmp(table_text(check, "name"), name) == 0) {
        *most = table_number(check, "max_score");
        return table_number(check, "score");
    }
    return -1;
}

static bool give_check(const Book *book, BookRow *row, int n, const Override *override) {
    double most = 0;
    const json_t *lab = row->entry >= 0 ? table_lab(book->table, row->entry, n) : NULL;
    const double old = check_points(lab, override->check, &most);
    if (old < 0)
        return override_fail(book, override, "there is no measured check", override->check,
                             "take its name from the report, or give points for the whole lab");
    row->marks[n].points += override->points - old;
    return true;
}

static void note_points(const Book *book, BookRow *row, const Override *override, double before) {
    char text[1000];
    const int n = lab_number(book, override->lab);
    snprintf(text, sizeof text, "lab %s%s%.80s: %.2f instead of %.2f: %.600s", override->lab,
             override->check[0] ? ", " : "", override->check, row->marks[n].points, before, override->note);
    book_note(row, text);
}

static bool has_due_date(const Book *book, const char *lab) {
    for (int i = 0; i < book->late.count; i++)
        if (strcmp(book->late.labs[i], lab) == 0)
            return true;
    return false;
}

// Gives what one override says of the days, or of the points.
static bool apply(Book *book, const Override *override, bool days) {
    const int n = lab_number(book, override->lab);
    if (n < 0)
        return override_fail(book, override, "this run has no lab", override->lab, "remove the row");
    if (override->late_days >= 0 && !has_due_date(book, override->lab))
        return override_fail(book, override, "no due date is known of lab", override->lab,
                             "give a rule by --due");
    BookRow *row = find_row(book, override);
    if (!row)
        return false;
    BookMark *mark = &row->marks[n];
    const double before = mark->points;
    if (days && override->late_days >= 0) {
        mark->late_days = override->late_days;
        mark->days_given = true;
    }
    if (days || override->points < 0)
        return true;
    if (override->check[0] && !give_check(book, row, n, override))
        return false;
    if (!override->check[0])
        mark->points = override->points;
    mark->known = mark->overridden = true;
    note_points(book, row, override, before);
    return true;
}

bool book_marks_fill(Book *book) {
    for (int r = 0; r < book->count; r++) {
        measure(book, &book->rows[r]);
        count_days(book, &book->rows[r]);
    }
    for (int o = 0; o < book->overrides.count; o++)
        if (!apply(book, &book->overrides.list[o], true))
            return false;
    for (int r = 0; r < book->count; r++)
        take_days(book, &book->rows[r]);
    for (int o = 0; o < book->overrides.count; o++)
        if (!apply(book, &book->overrides.list[o], false))
            return false;
    for (int r = 0; r < book->count; r++)
        for (int n = 0; n < book->table->plan->lab_count; n++)
            book->rows[r].total += book->rows[r].marks[n].points;
    return true;
}
