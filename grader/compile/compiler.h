// Turns a folder with a lab's C file into lab.so.
#pragma once

#include "jail/jail.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { COMPILE_LOG = 16 * 1024, COMPILE_PLACE = 128 };

// Compiles folder/lab.c, which is given what given_place has placed there (else everything), with fixed
// arguments and limits, in the jail (NULL: it is our own, outside). `log` gets what gcc says (errors or
// warnings). False with a message when there is no lab.so.
bool compiler_build(const char *folder, const Jail *jail, char log[COMPILE_LOG]);

// The same with AddressSanitizer, for a WorkerClient with `address`.
bool compiler_build_for_address(const char *folder, const Jail *jail, char log[COMPILE_LOG]);

// Writes where an offset in folder/lab.so stands in the source ("lab.c:12"), from the debug information of
// lab.so, which is read in the jail (NULL: outside). False when it is nowhere.
bool compiler_locate(const char *folder, const Jail *jail, uint64_t offset, char place[COMPILE_PLACE]);
