// Finds a file that a student has renamed without meaning to.
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum { FIND_FILE_NAME = 256 };

// The name in `folder` of the file that was handed out as `name`: that name, else one that differs only in
// the case of its letters, else one with what systems add ("lab (1).c", "lab-1.c", "lab.c.txt", "Copy of
// lab.c"). False when there is none.
bool find_file(char found[FIND_FILE_NAME], const char *folder, const char *name);

// Its text, as files_read_untrusted gives it: the caller frees it; NULL with a message, which names `name`
// where there is no such file.
char *find_file_read(const char *folder, const char *name, size_t limit);
