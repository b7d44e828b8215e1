// The records of a class, read once, and what its reports look up in them.
#pragma once

#include "class/origin.h"
#include "class/run_settings.h"
#include "class/roster.h"

#include <jansson.h>
#include <stdbool.h>

typedef struct Table {
    const Roster *roster;
    const RunSettings *plan;
    const Origin *origin;       // what grades are made by now
    json_t **records;           // one an entry, NULL where there is none
    char (*stale)[ORIGIN_TEXT]; // one an entry: what is another now than when it was graded; "" for nothing
} Table;

// Reads the records of the roll's entries from OUT (NULL: there are none). All three must outlive the table.
// Stale is what was graded by another rubric than today's, and where several graders were at work, what was
// not by this one.
void table_read(Table *table, const char *output, const Roster *roster, const RunSettings *plan,
                const Origin *origin);
void table_free(Table *table); // accepts a zeroed table

// Has entry i a grade?
bool table_is_graded(const Table *table, int i);

// Why entry i is not graded.
const char *table_reason(const Table *table, int i);

// Entry i's result of the plan's lab n, as in report/report.schema.json; NULL when it is not graded.
const json_t *table_lab(const Table *table, int i, int n);

// A number or a text of it; 0 or "" when there is none.
double table_number(const json_t *object, const char *key);
const char *table_text(const json_t *object, const char *key);

// "passed": all labs; else "failed", or "not graded".
const char *table_status(const Table *table, int i);

// Points of all labs.
double table_total(const Table *table, int i);
