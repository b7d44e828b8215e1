// What the suite found, for the page and for other programs.
#pragma once

#include "stability/row.h"

#include <jansson.h>

// One entry of "rows" in stability.json, whose format is stability.schema.json.
json_t *row_json(const RowResult *result);
