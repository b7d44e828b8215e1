// Source text as editors and systems store it.
#pragma once

#include <stdbool.h>
#include <stddef.h>

// Makes plain text of `text` in place, a string of `size` bytes with a 0 behind: drops a byte order mark, and
// ends lines by LF where they all end by CR alone. False with a message that names the file and the remedy:
// UTF-16, a document of an office program, or a byte 0 inside.
bool text_check(char *text, size_t size, const char *name);
