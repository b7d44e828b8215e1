// What the suite found, for the page and for other programs.
#pragma once

#include "row.h"

#include <jansson.h>

// One entry of "rows" in stability.json, whose format is stability.schema.json. `message` is NULL or says why
// the row could not run. The frames' files are named by row_frame_name.
json_t *row_json(const Row *row, const Findings *findings, const char *message);

// "stability-07-0.png": the file of a row's frame in the folder of the JSON.
void row_frame_name(char name[64], const Row *row, int slot);
