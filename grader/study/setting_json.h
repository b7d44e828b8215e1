// A setting as records have it.
#pragma once

#include "study/truth_view.h"

#include <jansson.h>

// An object of the setting's knobs and their values; freed by the caller.
json_t *setting_json(const Setting *setting);
