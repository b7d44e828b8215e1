// What every process inside may read of ours lies in a private folder, copied: so the project's folder itself
// is never shown, and the user inside need not be able to reach it.
#pragma once

#include "base/files.h"

#include <stdbool.h>

// Makes the folder and copies the worker, the programs of inside/, the shared shaders and the headers into
// it. False with a message.
bool stage_create(char stage[FILES_PATH]);

// Copies a file or a folder, all but what ends in .c, to the new file or folder `to`. False with a message.
bool stage_copy(const char *from, const char *to);

// The path outside of a part that stage_create copies.
void stage_source(const char *part, char path[FILES_PATH]);

void stage_destroy(const char *stage); // accepts ""
