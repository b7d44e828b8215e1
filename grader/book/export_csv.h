// CSV files that learning systems import; book/README.md says what their columns mean.
#pragma once

#include "book/book.h"

// Each writes its file into the folder. False with a message.
bool export_canvas(const Book *book, const char *folder);
bool export_moodle(const Book *book, const char *folder); // and the worksheet, where the list is one
bool export_gradescope(const Book *book, const char *folder);
