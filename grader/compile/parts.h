// The parts that a lab was handed out in: each function of its files, and of each file what stands outside of
// functions. A version of the lab in which one part is as it was handed out shows what the rest of it does.
//
// Interface: parts_list takes the files apart, parts_destroy frees them. No solution is needed.
#pragma once

#include "compile/functions.h"
#include "compile/rubric.h"

typedef struct LabPart {
    int file;             // of rubric->files
    const char *function; // its name; "": what stands outside of functions
    bool whole;           // all of the file, where tasks are to be done outside of functions
} LabPart;

typedef struct Parts {
    const Rubric *rubric;
    char *texts[RUBRIC_MAX_FILES];      // as they were handed out; owned
    Functions handed[RUBRIC_MAX_FILES]; // of them
    LabPart list[EXAM_MAX_PARTS];       // in the order of the files and the functions in them
    int count;
} Parts;

// Of the files' texts as they were handed out, which become the list's. A file that cannot be taken apart is
// one part; what is more than EXAM_MAX_PARTS is left out.
void parts_list(Parts *parts, const Rubric *rubric, char *const texts[]);
void parts_destroy(Parts *parts); // accepts a zeroed one

// Is the task to be done in the part: does its TODO stand there?
bool parts_have_task(const Parts *parts, int p, const char *task);

// Is the part in this version of its file as it was handed out, but for blanks and comments?
bool parts_same(const Parts *parts, int p, const Functions *version);

// Has this version of its file a part of this name?
bool parts_exist(const Parts *parts, int p, const Functions *version);

// This version of the file, with the parts p and q (-1: none) of that file as they were handed out. Freed by
// the caller; NULL when there is no memory.
char *parts_reset(const Parts *parts, int file, const Functions *version, int p, int q);
