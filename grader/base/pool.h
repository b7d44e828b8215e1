// Some processes of ours that do numbered jobs; one that dies or hangs takes only its job with it.
#pragma once

#include <stdbool.h>

enum { POOL_REASON = 400 };

typedef struct Outcome {
    int job;
    bool done;             // else for a fault of ours, which may go away: it is tried again, in a new process
    double score, maximum; // for the progress
    char reason[POOL_REASON];
} Outcome;

typedef struct Pool {
    int processes;
    int tries;      // for each job
    double seconds; // that a job may take before its process is killed
    void *context;
    void (*work)(Outcome *outcome, void *context);           // in a process of the pool
    void (*finished)(const Outcome *outcome, void *context); // here, in the order in which they end; with the
                                                             // last try's outcome of each job
} Pool;

// Does the jobs in their order, and waits. Ends early, with a message and false, when no process can be
// started, or when many jobs fail one after the other and none was done: then it is not the jobs' fault. The
// pool's processes end with ours.
bool pool_run(const Pool *pool, const int *jobs, int count);
