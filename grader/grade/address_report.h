// What AddressSanitizer printed, in one sentence.
#pragma once

#include "compile/rubric.h"

#include <stdbool.h>
#include <stddef.h>

// Writes "heap-buffer-overflow in bake (lab.c:80): writes 4 bytes just past the end of an array of 64 bytes
// made at lab.c:41" from the first report in `printed`. False when there is none, or when no place in it lies
// in a file of the lab. The text is the submission's to write: clean it before it is shown.
bool address_report_read(char *text, size_t size, const char *printed, const Rubric *rubric);
