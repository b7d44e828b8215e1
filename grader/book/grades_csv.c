#include "book/grades_csv.h"

#include "base/csv_write.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>

// Why there is no grade, or the first thing that kept a lab from being drawn.
static const char *reason(const Table *table, int i) {
    if (i < 0)
        return "";
    if (!table_is_graded(table, i))
        return table_reason(table, i);
    for (int n = 0; n < table->plan->lab_count; n++)
        if (table_text(table_lab(table, i, n), "message")[0])
            return table_text(table_lab(table, i, n), "message");
    return "";
}

static bool has_notes(const Book *book) {
    bool has = book->listed || book->ruled;
    for (int r = 0; !has && r < book->count; r++)
        has = book->rows[r].note != NULL;
    return has;
}

static void write_points(FILE *out, bool known, double points) {
    fputc(',', out);
    if (known)
        fprintf(out, "%.2f", points);
}

static void write_time(FILE *out, const Book *book, const BookRow *row) {
    char text[BOOK_TIME_TEXT];
    BookClock clock;
    book_time_text(text, book_time(book, row, &clock));
    fprintf(out, ",%s,%s", text, book_clock_name(clock));
}

static void write_row(FILE *out, const Book *book, const BookRow *row) {
    const int labs = book->table->plan->lab_count;
    const RosterEntry *entry = row->entry >= 0 ? &book->table->roster->entries[row->entry] : NULL;
    csv_write_cell(out, entry ? entry->shown : "");
    for (int n = 0; n < labs; n++)
        write_points(out, row->marks[n].known, row->marks[n].points);
    write_points(out, book_has_points(book, row), row->total);
    fprintf(out, ",%s,", book_status(book, row));
    csv_write_cell(out, book_name(book, row));
    fputc(',', out);
    csv_write_cell(out, book_id(book, row));
    fputs(entry && entry->late ? ",late," : ",,", out);
    csv_write_cell(out, reason(book->table, row->entry));
    for (int n = 0; book->ruled && n < labs; n++)
        write_points(out, row->marks[n].measured, row->marks[n].score);
    if (book->late.given)
        write_time(out, book, row);
    if (has_notes(book)) {
        fputc(',', out);
        csv_write_cell(out, row->note ? row->note : "");
    }
    fputc('\n', out);
}

static void write_heads(FILE *out, const Book *book) {
    const RunSettings *plan = book->table->plan;
    fputs("submission", out);
    for (int n = 0; n < plan->lab_count; n++)
        fprintf(out, ",lab %s", plan->labs[n]);
    fputs(",total,status,student,id,late,reason", out);
    for (int n = 0; book->ruled && n < plan->lab_count; n++)
        fprintf(out, ",lab %s measured", plan->labs[n]);
    fputs(book->late.given ? ",handed in,time by" : "", out);
    fputs(has_notes(book) ? ",note\n" : "\n", out);
}

bool grades_csv_write(const char *output, const Book *book) {
    char path[FILES_PATH], *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    INVARIANT(out);
    write_heads(out, book);
    for (int r = 0; r < book->count; r++)
        write_row(out, book, &book->rows[r]);
    bool whole = fclose(out) == 0;
    INVARIANT(whole);
    files_join(path, output, "grades.csv");
    bool ok = files_write_whole(path, text, true);
    free(text);
    return ok;
}
