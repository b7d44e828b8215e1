// Finds a file that a student has renamed without meaning to.
#pragma once

#include <stdbool.h>

enum { FIND_FILE_NAME = 256 };

// The name in `folder` of the file that was handed out as `name`: that name, else one that differs only in
// the case of its letters, else one with what systems add ("lab (1).c", "lab-1.c", "lab.c.txt", "Copy of
// lab.c"). False when there is none.
bool find_file(char found[FIND_FILE_NAME], const char *folder, const char *name);
