// The command line of build/view; its settings are AppOptions.
#pragma once

#include "base/option_table.h"

extern const CommandLine view_command_line;
