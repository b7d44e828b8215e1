// Hand-ins of several students with one sheet of drawn numbers (predict/prediction_sheet.h): one has the
// other's file.
#pragma once

#include "book/book.h"

typedef struct SharedSheet {
    int lab;    // of the plan
    long sheet; // its number
    int row;    // of the book
} SharedSheet;

// Lab by lab, sheet by sheet, in the order of the rows.
typedef struct SharedSheets {
    SharedSheet *list;
    int count;
    double by_chance; // pairs of one sheet to be expected where each student draws his own, in all labs
} SharedSheets;

// Finds the sheets that more than one student has; attempts of one student are none. Only labs that were
// drawn tell their sheet. shared_sheets_destroy frees it.
void shared_sheets_find(SharedSheets *shared, const Book *book);
void shared_sheets_destroy(SharedSheets *shared); // accepts zeroed ones
