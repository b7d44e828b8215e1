// A child process with limits, spoken to through pipes, that never outlives us and never makes us wait too
// long.
#pragma once

#include "base/process_limits.h"

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

#define PROCESS_SLICE 0.1
#define PROCESS_MEMORY_SLICE 0.02 // where memory is watched

enum { PROCESS_OUTPUT = 64 * 1024, PROCESS_FLOOD = 4 * 1024 * 1024 };

typedef enum ProcessState {
    PROCESS_RUNNING,
    PROCESS_ENDED,     // exited or died: see status
    PROCESS_TIMED_OUT, // killed: the wall time was over
    PROCESS_TOO_LARGE, // killed: it held more than resident_mib, or that cannot be seen
    PROCESS_FLOODED,   // killed: it printed more than PROCESS_FLOOD bytes
    PROCESS_DEAF       // killed: what it replies cannot be read, which is not its fault
} ProcessState;

typedef struct Process {
    pid_t pid;
    int input, replies, output; // our ends: its descriptor 0, its 3, and its 1 and 2 together; -1 when closed
    unsigned resident_mib;      // the limit, 0 for none
    double deadline;            // seconds of the monotonic clock
    atomic_bool cancelled;      // set by another thread: the time is over within PROCESS_SLICE seconds
    ProcessState state;
    bool wrapped;              // it is another program that tells a death by signal N as exit status 128 + N
    int status;                // as waitpid gives it, once the process was reaped
    double cpu_seconds;        // processor time of the group, once reaped
    long peak_mib;             // resident memory of the largest in the group at its peak, once reaped
    size_t printed;            // bytes it printed in all
    char text[PROCESS_OUTPUT]; // the first of them, a string
} Process;

// Starts arguments[0] (looked for in PATH) in `folder` with exactly `environment`. On failure: a message and
// a zeroed process.
bool process_start(Process *process, char *const *arguments, char *const *environment, const char *folder,
                   const ProcessLimits *limits);

// The same in two steps, for a child of ours that somebody else forks: our ends and its descriptors 0, 1 and
// 3, of which the second step, with its number, closes ours. Below 1: there is none; a message, and all is
// freed.
bool process_open(Process *process, int theirs[3], const ProcessLimits *limits);
bool process_opened(Process *process, const int theirs[3], pid_t pid);

// Sends `request` and reads exactly reply_size bytes. False when the process ended, timed out or flooded
// before.
bool process_exchange(Process *process, const void *request, size_t request_size, void *reply,
                      size_t reply_size);

// Takes the next `size` bytes that a process which has ended wrote to its replies before; false when there
// are fewer.
bool process_take_rest(Process *process, void *reply, size_t size);

// Forgets what it has printed so far.
void process_forget_output(Process *process);

// Waits for the process to end by itself (collecting what it prints) or to break a limit.
void process_wait(Process *process);

// Kills what is left of the process and its group, waits for the end of them all and frees everything.
// Accepts a zeroed process.
void process_stop(Process *process);

// Seconds of the monotonic clock.
double process_now(void);
