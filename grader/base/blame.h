// Whose fault it is that something cannot be read.
#pragma once

#include <stdbool.h>

// After a failure: does this errno say that the machine lacks something, and not that what was handed in
// cannot be read as it is (missing, a link, forbidden)?
bool blame_is_ours(int error);
