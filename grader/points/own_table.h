// The table that build/points printed, as make study keeps it: a student's settings, each beside ours.
#pragma once

#include "base/csv.h"

#include <stdbool.h>

// One setting that the student's lab drew. Strings belong to the table.
typedef struct OwnRow {
    const char *title; // of the scene
    const char *method, *setting;
    double error, milliseconds;         // the student's; an error is a share from 0 to 1
    double our_error, our_milliseconds; // recorded, the time scaled to this machine
} OwnRow;

typedef struct OwnTable {
    Csv csv;
    OwnRow *rows; // of a scene one after the other
    int count;
} OwnTable;

// Reads the table; rows that say nothing are left out. False with a message when there is no such file, or
// when it is no such table.
bool own_table_read(OwnTable *table, const char *path);
void own_table_destroy(OwnTable *table); // accepts a zeroed table

// The first row of the scene after that of `row`; `count` after the last.
int own_table_next_scene(const OwnTable *table, int row);

// In the scene that begins with `row`: where the student erred least, and there the faster one.
int own_table_best(const OwnTable *table, int row);

// In that scene: which of ours takes at most half of the time that the student's row `best` takes, and errs
// least; -1 when none does.
int own_table_quicker(const OwnTable *table, int row, int best);
