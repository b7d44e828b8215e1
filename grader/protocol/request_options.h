// Parts of a request from the command line.
#pragma once

#include "protocol/protocol.h"

#include <stdbool.h>

// "NAME=VALUE" and "WIDTHxHEIGHT"; false with a message for another text.
bool request_take_knob(Request *request, const char *text);
bool request_take_size(Request *request, const char *text);
