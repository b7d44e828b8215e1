// Points that people gave, by hand and with a note, where they do not agree with what was measured.
#pragma once

#include "base/csv.h"

#include <stdbool.h>

enum { OVERRIDE_WHOLE = -1, OVERRIDE_NONE = -1 };

typedef struct Override {
    int row;             // of the CSV
    const char *student; // a number, login, mail or name, or a hand-in's name
    char lab[3];
    const char *check; // the name of a check; "": the whole lab
    double points;     // OVERRIDE_NONE: only the lateness is another
    int late_days;     // that count in the place of what was measured; OVERRIDE_NONE: what was measured does
    const char *note;  // why; never empty
} Override;

typedef struct Overrides {
    Csv csv;
    Override *list;
    int count;
} Overrides;

// Reads a CSV with the columns student, lab, note, and points, late or both; a column check where only the
// points of a check are others. False with a message.
bool overrides_read(Overrides *overrides, const char *path);
void overrides_destroy(Overrides *overrides); // accepts a zeroed list
