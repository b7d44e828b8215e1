// Turns a folder with a lab's C file into lab.so.
#pragma once

#include "jail/jail.h"

#include <stdbool.h>
#include <stddef.h>

enum { COMPILE_LOG = 16 * 1024 };

// Compiles folder/lab.c, which is given what given_place has placed there (else everything), with fixed
// arguments and limits, in the jail (NULL: it is our own, outside). `log` gets what gcc says (errors or
// warnings). False with a message when there is no lab.so.
bool compiler_build(const char *folder, const Jail *jail, char log[COMPILE_LOG]);

// Replaces "@0xOFFSET@" in `text` by "lab.c:LINE", from the debug information of folder/lab.so, which is read
// in the jail (NULL: outside).
void compiler_locate(const char *folder, const Jail *jail, char *text, size_t size);
