// Parts of a request from the command line: the `take` of an Option whose target is a Request (see
// base/option_values.h).
#pragma once

#include <stdbool.h>

// "NAME=VALUE", one more knob.
bool request_take_knob(void *request, const char *text);

// "WIDTHxHEIGHT", up to PROTOCOL_MAX_SIZE.
bool request_take_size(void *request, const char *text);

// The name of a view.
bool request_take_view(void *request, const char *text);
