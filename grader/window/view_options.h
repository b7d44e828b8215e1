// The command line of build/view.
#pragma once

#include "window/app.h"

// Reads the arguments; false with a message for what does not make sense.
bool view_options_parse(AppOptions *options, int count, char **arguments);

// What the program says of itself.
extern const char arguments_usage[];
