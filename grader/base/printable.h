// Names of any bytes as text, and as safe file names.
#pragma once

#include <stddef.h>

enum { ESCAPE_FILE_NAME = 48 };

// The name as text that fits JSON, CSV, HTML and a terminal: printable UTF-8 stays, a backslash becomes \\,
// every byte of anything else (control characters, invisible and direction marks, what is not UTF-8) becomes
// \xNN. Different names give different texts. Freed by the caller.
char *printable_name(const char *bytes);

// The name whose text this is; NULL when it is none that printable_name gives. Freed by the caller.
char *printable_undo(const char *text);

// A file name for what belongs to the name: its first letters and digits, then a hash of all of it (FNV-1a,
// 64 bits).
void printable_file_name(char file[ESCAPE_FILE_NAME], const char *bytes);

// How many bytes of the text are UTF-8, as RFC 3629 has it, before the first that are not.
size_t printable_utf8(const char *text);

// How many columns the text takes in a terminal: letters of East Asia and pictures take two, marks upon
// letters none.
int printable_columns(const char *text);

// How many bytes of the text take at most this many columns.
size_t printable_clip(const char *text, int columns);
