#include "book/book.h"

#include "class/submission_record.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>

void book_note(BookRow *row, const char *text) {
    char *longer;
    const int length = asprintf(&longer, "%s%s%s", row->note ? row->note : "", row->note ? "; " : "", text);
    INVARIANT(length >= 0);
    free(row->note);
    row->note = longer;
}

const Student *book_student(const Book *book, const BookRow *row) {
    return row->student >= 0 ? &book->list.students[row->student] : NULL;
}

const char *book_name(const Book *book, const BookRow *row) {
    const Student *student = book_student(book, row);
    if (student && student->fields[STUDENT_NAME][0])
        return student->fields[STUDENT_NAME];
    return row->entry >= 0 ? book->table->roster->entries[row->entry].student : student_key(student);
}

const char *book_id(const Book *book, const BookRow *row) {
    const Student *student = book_student(book, row);
    const char *key = student ? student_key(student) : "";
    if (key[0] && key != student->fields[STUDENT_NAME])
        return key;
    return row->entry >= 0 ? book->table->roster->entries[row->entry].id : "";
}

time_t book_time_of(const Student *student, time_t time, bool told, BookClock *clock) {
    const bool listed = student && student->handed_in != 0;
    *clock = listed ? CLOCK_LIST : time == 0 ? CLOCK_NONE : told ? CLOCK_NAME : CLOCK_FILES;
    return listed ? student->handed_in : time;
}

time_t book_time(const Book *book, const BookRow *row, BookClock *clock) {
    bool told = false;
    const time_t time = row->entry >= 0 ? submission_record_time(book->table->records[row->entry], &told) : 0;
    return book_time_of(book_student(book, row), time, told, clock);
}

const char *book_clock_name(BookClock clock) {
    static const char *const names[CLOCK_COUNT] = {"", "list", "name", "files"};
    return names[clock];
}

void book_time_text(char text[BOOK_TIME_TEXT], time_t time) {
    struct tm parts;
    if (time == 0 || !localtime_r(&time, &parts) ||
        strftime(text, BOOK_TIME_TEXT, "%Y-%m-%d %H:%M:%S %z", &parts) == 0)
        text[0] = '\0';
}

int book_count_by_files(const Book *book) {
    int count = 0;
    for (int r = 0; r < book->count; r++) {
        BookClock clock;
        book_time(book, &book->rows[r], &clock);
        count += clock == CLOCK_FILES;
    }
    return count;
}

const char *book_status(const Book *book, const BookRow *row) {
    return row->entry >= 0 ? table_status(book->table, row->entry) : "not handed in";
}

bool book_has_points(const Book *book, const BookRow *row) {
    for (int n = 0; n < book->table->plan->lab_count; n++)
        if (row->marks[n].known)
            return true;
    return false;
}

bool book_counts(const Book *book, const BookRow *row) {
    if (!book->listed)
        return true;
    for (const BookRow *other = book->rows; row->student >= 0 && other < book->rows + book->count; other++)
        if (other != row && other->student == row->student &&
            (other->total > row->total || (other->total == row->total && other < row)))
            return false;
    return row->student >= 0;
}
