#include "base/installed.h"

#include "base/files.h"

#include <stdlib.h>
#include <string.h>

bool installed_library(const char *name) {
    enum { LIMIT = 64 << 20 };
    size_t size;
    char *cache = files_read_bytes("/etc/ld.so.cache", LIMIT, &size);
    const bool found = !cache || memmem(cache, size, name, strlen(name) + 1) != NULL;
    free(cache);
    return found;
}
