// What is told when a lab is done, and no earlier: solutions/NN-name/afterword.json. It holds the answers to
// the handout's questions, so no student meets them by reading the lab's folder.
#pragma once

#include "compile/rubric.h"

#include <stdbool.h>

typedef struct AfterwordAnswer {
    const char *about; // what the question is about, in a few words
    const char *parts[AFTERWORD_MAX_PARTS];
    int part_count;
} AfterwordAnswer;

// All strings belong to the afterword and live until afterword_destroy. Backticks and *stars* mark code and
// knobs, as in a handout.
typedef struct Afterword {
    const char *idea; // of the lab, in two sentences; NULL: the lab has no afterword
    AfterwordAnswer answers[AFTERWORD_QUESTIONS]; // in the order of the handout's questions
    const char *other_way;                        // how else it can be done, in words
    const char *tries[AFTERWORD_MAX_PARTS];
    int try_count;
    json_t *json; // where the strings live
} Afterword;

// Reads the afterword of a rubric that was read; without the file it stays empty. False with a message that
// names file and entry.
bool afterword_load(Afterword *afterword, const Rubric *rubric);

void afterword_destroy(Afterword *afterword); // accepts a zeroed afterword
