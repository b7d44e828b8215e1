#include "compile/given.h"

#include "scene/check.h"
#include "base/files.h"
#include "base/places.h"
#include "jail/stage.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

bool given_place(const char *folder, const char *id, const Jail *jail) {
    char part[64], from[FILES_PATH], to[FILES_PATH];
    files_join(to, folder, "given");
    if (files_exists(to))
        return true;
    snprintf(part, sizeof part, "given/%.32s", id);
    places_build_path(from, part);
    if (jail)
        return stage_copy(from, to);
    return symlink(from, to) == 0 || check_fail("%s cannot be linked to %s: %s", from, to, strerror(errno));
}
