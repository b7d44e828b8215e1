// The command line of build/grade.
#pragma once

#include "report/report.h"
#include "grade/session.h"

#include <stdbool.h>

enum { EXIT_ALL_PASSED, EXIT_NOT_ALL, EXIT_USAGE, EXIT_COULD_NOT };

typedef struct Options {
    GradeOptions grade;
    ReportFormat format;
    bool seeded;     // --seed was given
    bool trusted;    // no jail
    JailRoute route; // the only one to take; JAIL_NONE: any
    const char *labs[COURSE_MAX_LABS];
    int lab_count;          // 0: all
    const char *output;     // a folder, NULL for none
    bool record;            // note the points in the student's progress
    const char *submission; // of one student; NULL with --class
    // Of --class:
    const char *class_folder; // NULL without
    const char **only;        // names, owned
    int only_count;
    int jobs; // 0: one a processor
    bool resume, gather, list;
    bool timed; // --timeout was given
} Options;

extern const char options_usage[];

// Reads the command line. False with a message that says what is wrong with it.
bool options_parse(Options *options, int count, char **arguments);
