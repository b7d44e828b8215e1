#include "study/growing_file.h"

#include "scene/check.h"

#include <stdlib.h>

bool growing_file_begin(GrowingFile *file, const char *folder, const char *name) {
    files_join(file->path, folder, name);
    file->out = open_memstream(&file->text, &file->size);
    return file->out || check_fail("no memory for %s", file->path);
}

bool growing_file_end(GrowingFile *file) {
    bool ok = fclose(file->out) == 0 && files_write_whole(file->path, file->text, true);
    free(file->text);
    return ok || check_fail("no memory for %s", file->path);
}
