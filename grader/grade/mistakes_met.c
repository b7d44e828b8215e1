#include "grade/mistakes_met.h"

#include <string.h>

// Causes read "NAME" or "NAME, or OTHER NAME".
static bool begins_with(const char *cause, const char *name) {
    const size_t length = strlen(name);
    return strncmp(cause, name, length) == 0 && (cause[length] == '\0' || cause[length] == ',');
}

void mistakes_met_add(MistakesMet *met, const Rubric *rubric, const char *cause) {
    const char *name = NULL;
    for (int m = 0; m < rubric->mistake_count && !name; m++)
        if (begins_with(cause, rubric->mistakes[m].name))
            name = rubric->mistakes[m].name;
    for (int i = 0; i < met->count && name; i++)
        if (met->names[i] == name)
            name = NULL;
    if (name && met->count < RUBRIC_MAX_CHECKS)
        met->names[met->count++] = name;
}
