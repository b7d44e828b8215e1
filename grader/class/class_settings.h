// What a class run is asked to do.
#pragma once

#include "base/option_values.h"
#include "jail/plan.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct ClassSettings {
    const char *folder; // of the submissions
    const char *output; // a folder; NULL: only `list` or `dry_run`
    LabList labs;       // none: all
    uint64_t seed;
    double seconds; // that a submission may run, per lab
    bool seeded,
        timed; // somebody asks for this seed, for these seconds: a run that goes on must have the same
    ContextKind context; // of a run that begins
    JailRoute route;     // the only one to take; JAIL_NONE: any
    const char **only;   // names of submissions: grades these (again) and gathers nothing; NULL: all
    int only_count;
    int jobs;          // submissions at a time; 0: one a processor
    bool resume;       // go on with the run in `output`
    bool gather;       // grade nothing, make the tables of the results
    bool no_swap;      // do not exchange parts of submissions to find the fault; of a run that begins
    bool all_attempts; // each attempt is graded, not only a student's newest
    bool list;         // only print the names of the results
    bool dry_run;      // grade nothing and write nothing: only look
} ClassSettings;
