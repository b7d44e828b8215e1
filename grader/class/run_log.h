// OUT/log: what a class run did and when, a line each, kept from run to run.
#pragma once

// Appends a line with the time before it. Says nothing when the log cannot be written: the run itself goes
// on.
void run_log(const char *output, const char *format, ...) __attribute__((format(printf, 2, 3)));

// Waits until no other process makes the tables in OUT. A descriptor for run_log_leave.
int run_log_enter(const char *output);
void run_log_leave(int descriptor);
