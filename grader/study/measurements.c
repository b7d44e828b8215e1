// Reads the state's lines into a table of times and errors by key, and appends each new one at once.
#include "study/measurements.h"

#include "scene/check.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

// A line ends with a full stop, which shows that it is whole.
#define TIME "time %" SCNx64 " %lf %lf .%n"

void measured_errors_add(MeasuredErrors *sum, const MeasuredErrors *errors, double share) {
    double *to = (double *)sum;
    const double *from = (const double *)errors;
    for (int i = 0; i < MEASURED_FIGURES; i++)
        to[i] += share * from[i];
}

static bool grow(void **items, int count, int *capacity, size_t size) {
    if (count < *capacity)
        return true;
    int more = 2 * *capacity + 256;
    void *moved = realloc(*items, (size_t)more * size);
    if (!moved)
        return check_fail("out of memory for %d measurements", more);
    *items = moved;
    *capacity = more;
    return true;
}

static bool keep_time(Measurements *state, const MeasuredTime *time) {
    if (!grow((void **)&state->times, state->time_count, &state->time_capacity, sizeof *time))
        return false;
    state->times[state->time_count++] = *time;
    return true;
}

static bool keep_errors(Measurements *state, const MeasuredError *error) {
    if (!grow((void **)&state->errors, state->error_count, &state->error_capacity, sizeof *error))
        return false;
    state->errors[state->error_count++] = *error;
    return true;
}

// The figures of a line that begins like one of errors; false when it is not whole.
static bool read_figures(const char *line, MeasuredError *error) {
    double *figures = (double *)&error->errors;
    int at = 0, end = 0, last = 0;
    if (sscanf(line, "errors %" SCNx64 "%n", &error->key, &at) != 1)
        return false;
    for (int i = 0; i < MEASURED_FIGURES; i++, at += end)
        if (sscanf(line + at, " %lf%n", &figures[i], &end) != 1)
            return false;
    sscanf(line + at, " .%n", &last);
    return last > 0;
}

static bool take_line(Measurements *state, const char *line) {
    MeasuredTime time;
    MeasuredError error;
    int end = 0;
    if (sscanf(line, TIME, &time.key, &time.prepare, &time.shade, &end) == 3 && end > 0)
        return keep_time(state, &time);
    if (read_figures(line, &error))
        return keep_errors(state, &error);
    return true; // cut off, or of another version: measured again
}

bool measurements_open(Measurements *state, const char *path) {
    char line[512];
    bool ok = true, whole = true;
    *state = (Measurements){.file = fopen(path, "a+")};
    if (!state->file)
        return check_fail("%s: %s", path, strerror(errno));
    rewind(state->file);
    while (ok && fgets(line, sizeof line, state->file)) {
        whole = strchr(line, '\n') != NULL;
        ok = take_line(state, line);
    }
    if (!whole)
        fputc('\n', state->file);
    return ok;
}

void measurements_close(Measurements *state) {
    if (state->file)
        fclose(state->file);
    free(state->times);
    free(state->errors);
    *state = (Measurements){0};
}

static bool flush(Measurements *state) {
    return (fflush(state->file) == 0 && !ferror(state->file)) ||
           check_fail("the study's state cannot be written: %s", strerror(errno));
}

bool measurements_add_time(Measurements *state, const MeasuredTime *time) {
    fprintf(state->file, "time %016" PRIx64 " %.6f %.6f .\n", time->key, time->prepare, time->shade);
    return keep_time(state, time) && flush(state);
}

bool measurements_add_errors(Measurements *state, uint64_t key, const MeasuredErrors *errors) {
    const double *figures = (const double *)errors;
    fprintf(state->file, "errors %016" PRIx64, key);
    for (int i = 0; i < MEASURED_FIGURES; i++)
        fprintf(state->file, " %.17g", figures[i]);
    fputs(" .\n", state->file);
    return keep_errors(state, &(MeasuredError){key, *errors}) && flush(state);
}

const MeasuredErrors *measurements_errors(const Measurements *state, uint64_t key) {
    for (int i = 0; i < state->error_count; i++)
        if (state->errors[i].key == key)
            return &state->errors[i].errors;
    return NULL;
}

int measurements_times(const Measurements *state, uint64_t key, MeasuredTime *times, int most) {
    int count = 0;
    for (int i = 0; i < state->time_count && count < most; i++)
        if (state->times[i].key == key)
            times[count++] = state->times[i];
    return count;
}
