// What this machine has, asked without loading it.
#pragma once

#include <stdbool.h>

// Is there a shared library of this name, "libOSMesa.so.8"? By the loader's cache; where there is none,
// nobody knows, and the answer is yes.
bool installed_library(const char *name);
