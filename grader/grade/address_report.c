// Looks in AddressSanitizer's report for the first line of each stack that lies in a file of the lab, and
// makes one sentence of the kind of fault, the function and the places.
#include "grade/address_report.h"

#include "scene/check.h"

#include <stdio.h>
#include <string.h>

enum { PLACE = 128 };

typedef struct LabPlace {
    char function[PLACE / 2], where[PLACE]; // "bake", "lab.c:80"
} LabPlace;

static bool is_of_lab(const char *file, const Rubric *rubric) {
    for (int i = 0; i < rubric->file_count; i++)
        if (strcmp(rubric->files[i], file) == 0)
            return true;
    return false;
}

// The first frame in a file of the lab, of the stack that begins at `stack` and ends with an empty line:
// "    #0 0x7f81670b0f32 in pad_chart lab.c:80".
static bool find_place(LabPlace *place, const char *stack, const Rubric *rubric) {
    for (const char *line = stack; line && *line && *line != '\n';) {
        char path[256], name[64];
        int number;
        const int found = sscanf(line, " #%*d %*x in %63s %255[^:\n]:%d", place->function, path, &number);
        const char *slash = found == 3 ? strrchr(path, '/') : NULL;
        if (found == 3) {
            snprintf(name, sizeof name, "%.63s", slash ? slash + 1 : path);
            snprintf(place->where, sizeof place->where, "%s:%d", name, number);
            if (is_of_lab(name, rubric))
                return true;
        }
        line = strchr(line, '\n');
        line = line ? line + 1 : NULL;
    }
    return false;
}

// The stack behind the line with these words.
static bool find_place_after(LabPlace *place, const char *report, const char *words, const Rubric *rubric) {
    const char *line = strstr(report, words);
    line = line ? strchr(line, '\n') : NULL;
    return line && find_place(place, line + 1, rubric);
}

static void append_access(char *text, size_t size, const char *kind, const char *report) {
    unsigned long bytes;
    const char *write = strstr(report, "\nWRITE of size "), *read = strstr(report, "\nREAD of size ");
    const char *access = write ? write : read;
    if (access && sscanf(access, write ? " WRITE of size %lu" : " READ of size %lu", &bytes) == 1)
        check_append(text, size, ": %s %lu byte%s", write ? "writes" : "reads", bytes, bytes == 1 ? "" : "s");
    if (strstr(report, "points to the zero page"))
        check_append(text, size, ": through a pointer that is NULL, or nearly");
    if (strcmp(kind, "stack-overflow") == 0)
        check_append(text, size,
                     ": a function that calls itself without end, or a local array that is too large");
}

// "is located 4 bytes to the right of 64-byte region" (gcc 12) or "is located 4 bytes after 64-byte region".
static void append_heap(char *text, size_t size, const char *report, const Rubric *rubric) {
    unsigned long distance, length;
    char side[32];
    LabPlace made;
    const char *located = strstr(report, " is located ");
    if (!located)
        return;
    if (sscanf(located, " is located %lu bytes %31[a-z ] %lu-byte region", &distance, side, &length) == 3) {
        const bool after = strstr(side, "right") || strstr(side, "after"),
                   inside = strstr(side, "inside") != NULL;
        if (inside)
            check_append(text, size, " of");
        else if (distance == 0)
            check_append(text, size, ", just %s of", after ? "past the end" : "before the start");
        else
            check_append(text, size, ", %lu bytes %s of", distance,
                         after ? "past the end" : "before the start");
        check_append(text, size, " an array of %lu bytes", length);
    }
    if (find_place_after(&made, report, "freed by thread", rubric))
        check_append(text, size, ", freed at %s", made.where);
    if (find_place_after(&made, report, "allocated by thread", rubric))
        check_append(text, size, ", made at %s", made.where);
}

// "'weights' (line 33) <== Memory access" or "global variable 'weights' defined in 'lab.c:12:14' (...) of
// size 64".
static void append_variable(char *text, size_t size, const char *report) {
    char name[64];
    int line;
    const char *mark = strstr(report, "<== Memory access"), *global = strstr(report, "global variable '");
    const char *start = mark;
    while (start && start > report && start[-1] != '\n')
        start--;
    const char *quote = start ? strchr(start, '\'') : NULL;
    if (quote && quote < mark && sscanf(quote, "'%63[^']' (line %d)", name, &line) == 2)
        check_append(text, size, ", outside of %s, which is defined in line %d", name, line);
    else if (global && sscanf(global, "global variable '%63[^']'", name) == 1)
        check_append(text, size, ", outside of %s", name);
}

bool address_report_read(char *text, size_t size, const char *printed, const Rubric *rubric) {
    static const char head[] = "ERROR: AddressSanitizer: ";
    char kind[64] = "";
    LabPlace place;
    const char *report = strstr(printed, head);
    const char *stack = report ? strstr(report, "\n    #0 ") : NULL;
    if (!stack || sscanf(report + strlen(head), "%63s", kind) != 1 ||
        !find_place(&place, stack + 1, rubric) ||
        strcmp(kind, "ABRT") == 0) // by itself, which is known already
        return false;
    if (strcmp(kind, "attempting") == 0)
        snprintf(kind, sizeof kind, "%s",
                 strstr(report, "attempting double-free") ? "double-free"
                                                          : "free of what malloc has not made");
    text[0] = '\0';
    check_append(text, size, "%s in %s (%s)", kind, place.function, place.where);
    append_access(text, size, kind, report);
    append_heap(text, size, report, rubric);
    append_variable(text, size, report);
    return true;
}
