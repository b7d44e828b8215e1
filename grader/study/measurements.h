// What has been measured, kept on disk line by line, so that a study that was stopped goes on where it was.
#pragma once

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

// How far a setting's frame is from the truth, and what it costs. Errors but `off` are means over the pixels
// that count, 0..1.
typedef struct MeasuredErrors {
    double edge_false_shadow, edge_false_light, interior_false_shadow, interior_false_light;
    double off;     // mean distance of the edge from the true one, pixels
    double rmse;    // root of the mean of squares
    double flip;    // mean of FLIP (truth/flip.h) of a white scene that the light falls on
    double center;  // mean difference to the truth at the pixels' centres
    double turning; // mean of what changes beyond the truth's changes, a frame: the light turns (motion.h)
    double moving;  // the same: the camera moves
    double reads, fragments, cleared; // counted of the first view's frame (counted_frame.h); 0 of the others
} MeasuredErrors;

enum { MEASURED_FIGURES = sizeof(MeasuredErrors) / sizeof(double) }; // all of them are double

typedef struct MeasuredTime {
    uint64_t key;
    double prepare, shade; // CPU or GPU time of a frame: what comes before the picture, and the picture; ms
} MeasuredTime;

typedef struct MeasuredError {
    uint64_t key;
    MeasuredErrors errors;
} MeasuredError;

typedef struct Measurements {
    FILE *file;
    MeasuredTime *times; // owned
    MeasuredError *errors;
    int time_count, time_capacity, error_count, error_capacity;
} Measurements;

// Adds a share of errors to others, figure by figure.
void measured_errors_add(MeasuredErrors *sum, const MeasuredErrors *errors, double share);

// Reads the file, if there is one, and opens it for more. A last line that was cut off is dropped. Keys say
// what was measured (by its content). False with a message.
bool measurements_open(Measurements *state, const char *path);
void measurements_close(Measurements *state); // accepts a zeroed state

// Adds a frame's times or a setting's errors and puts them on disk.
bool measurements_add_time(Measurements *state, const MeasuredTime *time);
bool measurements_add_errors(Measurements *state, uint64_t key, const MeasuredErrors *errors);

// The errors of a setting; NULL when they have not been measured.
const MeasuredErrors *measurements_errors(const Measurements *state, uint64_t key);

// Writes at most `most` times of the setting, in the order in which they were measured, and returns their
// number.
int measurements_times(const Measurements *state, uint64_t key, MeasuredTime *times, int most);
