// What the views of a lab show, in one line each: solutions/NN-name/captions.json, {"name of a stage": "what
// it shows"}. A lab need not have it.
#pragma once

#include "compile/rubric.h"

#include <stdbool.h>

typedef struct Captions {
    json_t *json; // where the strings live; NULL: there are none
} Captions;

// Reads the captions of a rubric that was read. False with a message that names file and entry.
bool captions_load(Captions *captions, const Rubric *rubric);
void captions_destroy(Captions *captions); // accepts zeroed captions

// What the view shows; "" when nothing is told. Valid until captions_destroy.
const char *captions_find(const Captions *captions, const char *view);
