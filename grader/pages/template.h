// A text with holes, {{name}}, from a file of the project; who fills them goes from hole to hole.
#pragma once

#include <stdbool.h>
#include <stdio.h>

typedef struct Template {
    char *text;       // owned
    const char *rest; // what was not written yet
    char hole[64];
} Template;

// Reads the file; its path is relative to the project ("grader/pages/shell.html"). False with a message.
bool template_open(Template *template, const char *file);

// Writes what stands before the next hole (unless `out` is NULL) and goes on behind the hole. Returns its
// name, valid until the next call; NULL when no hole was left and all is written.
const char *template_next(Template *template, FILE *out);
void template_close(Template *template); // accepts a zeroed template

// Writes a whole file of the project as it is. False with a message.
bool template_copy(FILE *out, const char *file);
