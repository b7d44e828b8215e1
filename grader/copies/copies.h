// Which hand-ins of a class have the same code: pairs for people to look at.
#pragma once

#include "class/class_settings.h"
#include "class/table.h"

// How far two labs are the same, comments and layout aside.
typedef enum CopyEqual { COPY_DIFFERS, COPY_BUT_NAMES, COPY_EVERY_WORD } CopyEqual;

typedef struct CopyPair {
    int lab;           // of the plan
    int first, second; // entries of the roster
    double percent;    // of what is their own
    CopyEqual equal;
} CopyPair;

// Lab by lab, the most alike first.
typedef struct Copies {
    CopyPair *pairs;
    int count;
} Copies;

// Reads all hand-ins again (archives in the jail), takes away what was handed out in labs/, and finds of each
// lab the pairs that share half of what is their own, or all. What more than four students and a tenth of the
// class have is no sign of anything and does not count. False with a message.
bool copies_find(Copies *copies, const Table *table, const ClassSettings *settings);
void copies_destroy(Copies *copies); // accepts zeroed copies

// "every word", "all but names"; "" for COPY_DIFFERS.
const char *copies_equal_name(CopyEqual equal);

// Writes OUT/copies.csv. False with a message.
bool copies_write(const Copies *copies, const Table *table, const char *output);
