// Turns a folder with a lab's C file into lab.so.
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum { COMPILE_LOG = 16 * 1024 };

// Compiles folder/lab.c with fixed arguments, in a process with limits. `log` gets what gcc says (errors or
// warnings). False with a message when there is no lab.so.
bool compile_lab(const char *folder, char log[COMPILE_LOG]);

// Replaces "@0xOFFSET@" in `text` by "lab.c:LINE", from the debug information of folder/lab.so.
void compile_locate(const char *folder, char *text, size_t size);
