// Makes a gradebook of the records and of what people wrote.
#pragma once

#include "book/book.h"

// The files that a book is made by; NULL: the one of that name that OUT holds, if it does.
typedef struct BookFiles {
    const char *roster, *overrides, *late;
    bool only_read; // keep nothing in OUT, which may be NULL, and fill no marks in: nothing is graded yet
} BookFiles;

// Can the files be read? False with a message.
bool book_check_files(const BookFiles *files);

// Keeps the files in OUT as roster.csv, overrides.csv and due.json, and makes the book. False with a
// message.
bool book_open(Book *book, const Table *table, const char *output, const BookFiles *files);
void book_close(Book *book); // accepts a zeroed book
