// Brings together hand-ins, the list of students, overrides and lateness: a row a student.
#include "book/book_open.h"

#include "book/book_marks.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char roster_name[] = "roster.csv", overrides_name[] = "overrides.csv", due_name[] = "due.json";

bool book_check_files(const BookFiles *files) {
    StudentList list = {0};
    Overrides overrides = {0};
    LateRule late;
    const bool ok = (!files->roster || student_list_read(&list, files->roster)) &&
                    (!files->overrides || overrides_read(&overrides, files->overrides)) &&
                    (!files->late || late_rule_read(&late, files->late));
    student_list_destroy(&list);
    overrides_destroy(&overrides);
    return ok;
}

// OUT/name, after `file` (NULL: none) was copied there; where nothing is to be written, the file itself.
// *there: is there one?
static bool keep(char path[FILES_PATH], const char *output, const char *name, const char *file,
                 bool only_read, bool *there) {
    bool ok = true;
    *there = file != NULL;
    if (file && only_read)
        return snprintf(path, FILES_PATH, "%s", file) < FILES_PATH || check_fail("%.100s: too long", file);
    if (!output)
        return true;
    files_join(path, output, name);
    if (file) {
        char *text = files_read(file, CSV_MAX_BYTES);
        ok = text && files_write_whole(path, text, true);
        free(text);
    }
    *there = ok && files_exists(path);
    return ok;
}

static bool read_files(Book *book, const char *output, const BookFiles *files) {
    const bool only_read = files->only_read;
    char path[FILES_PATH];
    bool there;
    if (!keep(path, output, roster_name, files->roster, only_read, &there) ||
        (there && !student_list_read(&book->list, path)))
        return false;
    book->listed = there;
    if (!only_read && (!keep(path, output, overrides_name, files->overrides, false, &there) ||
                       (there && !overrides_read(&book->overrides, path))))
        return false;
    book->ruled = !only_read && there;
    if (!keep(path, output, due_name, files->late, only_read, &there) ||
        (there && !late_rule_read(&book->late, path)))
        return false;
    book->ruled = book->ruled || there;
    return true;
}

static void add_row(Book *book, int entry, int student) {
    book->rows[book->count++] = (BookRow){.entry = entry, .student = student};
}

static void add_entries(Book *book, bool only_read) {
    const Roster *roster = book->table->roster;
    for (int i = 0; i < roster->count; i++) {
        const RosterEntry *entry = &roster->entries[i];
        const int student =
            book->listed ? student_list_find(&book->list, entry->id, entry->student) : BOOK_NONE;
        add_row(book, i, student >= 0 ? student : BOOK_NONE);
        if (book->listed && student == STUDENT_NOBODY)
            book_note(&book->rows[i], "not on the roster");
        if (student == STUDENT_SEVERAL)
            book_note(&book->rows[i],
                      "several on the roster have this name: put the number into the hand-in's name");
        if (!only_read && table_is_graded(book->table, i) && book->table->stale[i][0]) {
            char text[ORIGIN_TEXT + 60];
            snprintf(text, sizeof text, "graded with %s than today's: --resume grades it again",
                     book->table->stale[i]);
            book_note(&book->rows[i], text);
        }
    }
}

static void add_missing(Book *book) {
    int *rows = calloc((size_t)book->list.count + 1, sizeof *rows); // a student has handed in
    INVARIANT(rows);
    for (int r = 0; r < book->count; r++)
        if (book->rows[r].student >= 0)
            rows[book->rows[r].student]++;
    for (int r = 0; r < book->count; r++)
        if (book->rows[r].student >= 0 && rows[book->rows[r].student] > 1)
            book_note(&book->rows[r], "one of several hand-ins of this student");
    for (int s = 0; s < book->list.count; s++)
        if (rows[s] == 0)
            add_row(book, BOOK_NONE, s);
    free(rows);
}

bool book_open(Book *book, const Table *table, const char *output, const BookFiles *files) {
    *book = (Book){.table = table};
    bool ok = read_files(book, output, files);
    if (ok) {
        book->rows = calloc((size_t)table->roster->count + (size_t)book->list.count, sizeof *book->rows);
        INVARIANT(book->rows);
        add_entries(book, files->only_read);
        add_missing(book);
        ok = files->only_read || book_marks_fill(book);
    }
    if (!ok)
        book_close(book);
    return ok;
}

void book_close(Book *book) {
    for (int r = 0; r < book->count; r++)
        free(book->rows[r].note);
    free(book->rows);
    student_list_destroy(&book->list);
    overrides_destroy(&book->overrides);
    *book = (Book){0};
}
