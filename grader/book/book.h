// The gradebook: what was measured, who takes the course, what people decided, and what lateness costs.
#pragma once

#include "book/late_rule.h"
#include "book/overrides.h"
#include "book/student_list.h"
#include "class/table.h"
#include "copies/copies.h"

enum { BOOK_NONE = -1, BOOK_TIME_TEXT = 40 };

// By what it is known when something was handed in.
typedef enum BookClock {
    CLOCK_NONE, // it is not known
    CLOCK_LIST,
    CLOCK_NAME,  // of the hand-in, as the learning system wrote it
    CLOCK_FILES, // the newest change of a file, which a student can set
    CLOCK_COUNT
} BookClock;

// A student's points in a lab.
typedef struct BookMark {
    bool measured;   // there is a grade
    bool handed_in;  // ... of something
    bool known;      // there are points, measured or given by hand
    double score;    // measured
    double points;   // what counts
    double maximum;  // 0 where nothing was measured
    int late_days;   // in all
    int free_days;   // of them
    double taken;    // points that the lateness took
    bool days_given; // late_days are by hand
    bool overridden;
} BookMark;

typedef struct BookRow {
    int entry;                       // of the table; BOOK_NONE: nothing was handed in
    int student;                     // of the list; BOOK_NONE: not on it, or there is no list
    BookMark marks[COURSE_MAX_LABS]; // of the plan's labs
    double total;                    // of what counts
    char *note;                      // what people should know, as text; "" for nothing
} BookRow;

typedef struct Book {
    const Table *table;
    bool listed, ruled; // there is a list; there are overrides or a rule for lateness
    StudentList list;
    Overrides overrides;
    LateRule late;
    BookRow *rows; // the table's entries in their order, then who handed in nothing, in the list's order
    int count;
    const struct SharedSheets *sheets; // of predictions, that several students have; NULL: not looked for
    const Copies *copies;              // pairs with code in common; NULL: this run did not look for them
} Book;

// Appends to what people should know of a row.
void book_note(BookRow *row, const char *text);

// Who it is: by the list, else by the name of the hand-in. Texts.
const char *book_name(const Book *book, const BookRow *row);
const char *book_id(const Book *book, const BookRow *row);
const Student *book_student(const Book *book, const BookRow *row); // NULL: not on the list

// When it was handed in: by the list, else by the record; 0: unknown. *clock: by what.
time_t book_time(const Book *book, const BookRow *row, BookClock *clock);

// The same of a student (NULL: not on the list) whose hand-in has this time, which its name tells or not.
time_t book_time_of(const Student *student, time_t time, bool told, BookClock *clock);

// "list", "name" or "files"; "" for CLOCK_NONE.
const char *book_clock_name(BookClock clock);

// This machine's time with its zone; "" for 0.
void book_time_text(char text[BOOK_TIME_TEXT], time_t time);

// Of how many hand-ins do only the files tell when they came?
int book_count_by_files(const Book *book);

// "passed", "failed" or "not graded" as it was measured, else "not handed in".
const char *book_status(const Book *book, const BookRow *row);

// Are there points, measured or given by hand, in any lab?
bool book_has_points(const Book *book, const BookRow *row);

// Is this the row that counts for its student? With a list, who is not on it has none; of several hand-ins of
// a student the one with the most points has it.
bool book_counts(const Book *book, const BookRow *row);
