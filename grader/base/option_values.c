// Each function reads one kind of value (a seed, a size, a lab, a context) or says what the option takes.
#include "base/option_values.h"

#include "base/places.h"
#include "scene/check.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char DIGITS[] = "0123456789";

bool option_flag(void *target, const char *none) {
    (void)none;
    *(bool *)target = true;
    return true;
}

bool option_text(void *target, const char *text) {
    *(const char **)target = text;
    return true;
}

bool option_task(void *target, const char *text) {
    const size_t lab = strspn(text, DIGITS), task = text[lab] == '.' ? strspn(text + lab + 1, DIGITS) : 0;
    if (lab < 1 || task < 1 || text[lab + 1 + task])
        return check_fail("takes a task like 3.2, not \"%s\"", text);
    return option_text(target, text);
}

// Digits up to `end`; false when there are none or they are more than 64 bits hold.
static bool read_digits(uint64_t *number, const char *text, const char **end) {
    const size_t length = strspn(text, DIGITS);
    errno = 0;
    *number = strtoull(text, NULL, 10);
    *end = text + length;
    return length > 0 && errno == 0;
}

bool option_seed(void *target, const char *text) {
    const char *end;
    return (read_digits(target, text, &end) && *end == '\0') ||
           check_fail("takes a whole number from 0 to 2^64 - 1, not \"%s\"", text);
}

bool option_whole(int *number, const char *text, int least, int most) {
    uint64_t value;
    const char *end;
    if (!read_digits(&value, text, &end) || *end || value < (uint64_t)least || value > (uint64_t)most)
        return check_fail("takes a number from %d to %d, not \"%s\"", least, most, text);
    *number = (int)value;
    return true;
}

bool option_bit(uint32_t *bits, const char *text, int most) {
    int number = 0;
    if (!option_whole(&number, text, 0, most))
        return false;
    *bits |= 1U << number;
    return true;
}

bool option_decimal(double *number, const char *text) {
    char *end;
    if (strspn(text, "0123456789.eE+-") != strlen(text) || strcspn(text, DIGITS) == strlen(text))
        return check_fail("takes a number, not \"%s\"", text);
    *number = strtod(text, &end);
    return (*end == '\0' && isfinite(*number)) || check_fail("takes a number, not \"%s\"", text);
}

bool option_seconds(void *target, const char *text) {
    double *seconds = target;
    if (strspn(text, "0123456789.") == strlen(text) && option_decimal(seconds, text) && *seconds > 0 &&
        *seconds <= 3600)
        return true;
    check_clear();
    return check_fail("takes seconds above 0 and at most 3600, not \"%s\"", text);
}

bool option_size(int *width, int *height, const char *text, int most) {
    uint64_t sides[2];
    const char *end;
    const bool ok =
        read_digits(&sides[0], text, &end) && *end == 'x' && read_digits(&sides[1], end + 1, &end) && !*end;
    if (!ok || sides[0] < 1 || sides[1] < 1 || sides[0] > (uint64_t)most || sides[1] > (uint64_t)most)
        return check_fail("takes WIDTHxHEIGHT up to %d, not \"%s\"", most, text);
    *width = (int)sides[0];
    *height = (int)sides[1];
    return true;
}

bool option_context(void *target, const char *text) {
    if (context_parse(target, text))
        return true;
    check_clear();
    return check_fail("takes osmesa or egl: there is no context \"%s\"", text);
}

// "3" and "03" give "03".
static bool read_id(char id[3], const char *text) {
    const size_t length = strspn(text, DIGITS);
    if (length < 1 || length > 2 || text[length])
        return false;
    id[0] = length == 2 ? text[0] : '0';
    id[1] = text[length - 1];
    id[2] = '\0';
    return true;
}

static void append_id(const char *id, void *context) {
    char *names = context;
    check_append(names, 400, "%s%s", names[0] ? ", " : "", id);
}

static bool refuse_lab(const char *text) {
    char names[400] = "";
    check_clear();
    if (!places_list_labs(append_id, names))
        return false;
    return check_fail("takes a lab's number: there is no lab \"%s\"; there %s %s", text,
                      strchr(names, ',') ? "are" : "is", names[0] ? names : "none");
}

bool option_lab(void *target, const char *text) {
    char folder[FILES_PATH];
    return (read_id(target, text) && places_find_lab(folder, target)) || refuse_lab(text);
}

bool option_lab_of_student(void *target, const char *text) {
    char labs[FILES_PATH], folder[FILES_PATH];
    places_path(labs, "labs");
    if (read_id(target, text) &&
        (places_find_lab(folder, target) || places_find_lab_in(folder, labs, target))) {
        check_clear();
        return true;
    }
    return refuse_lab(text);
}

bool option_labs(void *target, const char *text) {
    LabList *labs = target;
    char id[3];
    if (!option_lab(id, text))
        return false;
    for (int i = 0; i < labs->count; i++)
        if (strcmp(labs->ids[i], id) == 0)
            return true;
    if (labs->count == COURSE_MAX_LABS)
        return check_fail("is given more than %d times", COURSE_MAX_LABS);
    memcpy(labs->ids[labs->count++], id, sizeof id);
    return true;
}
