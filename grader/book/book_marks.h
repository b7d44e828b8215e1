// Fills in what counts: measured points, less what lateness takes, or what people gave.
#pragma once

#include "book/book.h"

// Fills the marks of all rows, and notes why points are others than measured. False with a message: an
// override fits no student, lab or check.
bool book_marks_fill(Book *book);
