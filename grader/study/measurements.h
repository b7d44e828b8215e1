// What has been measured, kept on disk line by line, so that a study that was stopped goes on where it was.
#pragma once

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

// How far a setting's frame is from the truth. All but `off` are means over the pixels that count, 0..1.
typedef struct StateErrors {
    double edge_false_shadow, edge_false_light, interior_false_shadow, interior_false_light;
    double off;     // mean distance of the edge from the true one, pixels
    double partial; // share of the pixels that are neither wholly lit nor wholly dark
} StateErrors;

typedef struct StateTime {
    uint64_t key;
    double prepare, shade; // CPU time of a frame: what comes before the picture, and the picture; ms
} StateTime;

typedef struct StateError {
    uint64_t key;
    StateErrors errors;
} StateError;

typedef struct State {
    FILE *file;
    StateTime *times; // owned
    StateError *errors;
    int time_count, time_capacity, error_count, error_capacity;
} State;

// Reads the file, if there is one, and opens it for more. A last line that was cut off is dropped. Keys say
// what was measured (by its content). False with a message.
bool state_open(State *state, const char *path);
void state_close(State *state); // accepts a zeroed state

// Adds a frame's times or a setting's errors and puts them on disk.
bool state_add_time(State *state, const StateTime *time);
bool state_add_errors(State *state, uint64_t key, const StateErrors *errors);

// The errors of a setting; NULL when they have not been measured.
const StateErrors *state_errors(const State *state, uint64_t key);

// Writes at most `most` times of the setting, in the order in which they were measured, and returns their
// number.
int state_times(const State *state, uint64_t key, StateTime *times, int most);
