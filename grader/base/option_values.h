// What the values of options mean, the same in all programs: the `take` of an Option, or what one is made of.
// All refuse signs, spaces, hexadecimal numbers and anything behind the value. False with a message that goes
// on after the option's name: "takes ..., not \"...\"".
#pragma once

#include "base/limits.h"
#include "scene/context_kind.h"

#include <stdbool.h>
#include <stdint.h>

// Labs in the order in which they were given, each once.
typedef struct LabList {
    int count;
    char ids[COURSE_MAX_LABS][3]; // "03"
} LabList;

// To a bool: true. The value is NULL.
bool option_flag(void *target, const char *none);

// To a const char *: the text itself, which is never empty.
bool option_text(void *target, const char *text);

// To a uint64_t: a whole number from 0 to 2^64 - 1.
bool option_seed(void *target, const char *text);

// To a double: seconds above 0 and at most 3600.
bool option_seconds(void *target, const char *text);

// To a ContextKind: "osmesa" or "egl".
bool option_context(void *target, const char *text);

// To a char[3], or one more to a LabList: the lab "3" or "03" of solutions/ (or grader/recorded/). The
// message lists the labs.
bool option_lab(void *target, const char *text);
bool option_labs(void *target, const char *text);

// To a char[3]: the same, or a lab that stands only in labs/, as that of another course.
bool option_lab_of_student(void *target, const char *text);

// To a const char *: a task, "3.2".
bool option_task(void *target, const char *text);

// Parts of a `take`: a whole number from `least` to `most`, one from 0 to `most` (at most 31) whose bit is
// set beside those of earlier ones, a decimal number, and "WIDTHxHEIGHT" with sides from 1 to `most`.
bool option_whole(int *number, const char *text, int least, int most);
bool option_bit(uint32_t *bits, const char *text, int most);
bool option_decimal(double *number, const char *text);
bool option_size(int *width, int *height, const char *text, int most);
