// The gradebook for learning systems and for queries: OUT/export/.
#pragma once

#include "book/book.h"

typedef enum ExportKind {
    EXPORT_CANVAS,
    EXPORT_MOODLE,
    EXPORT_GRADESCOPE,
    EXPORT_SQLITE,
    EXPORT_KINDS
} ExportKind;

// To a bool[EXPORT_KINDS], of which one more becomes true: "canvas" and so on. False with a message for an
// option.
bool export_take(void *target, const char *name);

// Writes OUT/export/canvas.csv and so on for the kinds that are wanted, and for any of them
// OUT/export/feedback with a page for each student, named by the id (without points when `no_points`). False
// with a message.
bool export_write(const Book *book, const char *output, const bool kinds[EXPORT_KINDS], bool no_points);
