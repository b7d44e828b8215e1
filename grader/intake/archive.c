#include "intake/archive.h"

#include "scene/check.h"
#include "scene/count.h"

#include <string.h>
#include <strings.h>
#include <sys/statvfs.h>

size_t archive_stem(const char *name) {
    static const char *const ends[] = {".tar.gz", ".tar.bz2", ".tar.xz", ".tar.zst", ".zip", ".tar", ".tgz",
                                       ".tbz",    ".tbz2",    ".txz",    ".tzst",    ".7z",  ".rar"};
    const size_t length = strlen(name);
    for (size_t i = 0; i < COUNT(ends); i++)
        if (length > strlen(ends[i]) && strcasecmp(name + length - strlen(ends[i]), ends[i]) == 0)
            return length - strlen(ends[i]);
    return length;
}

bool archive_is_name(const char *name) {
    return name[archive_stem(name)] != '\0';
}

// Room for what an archive may hold, and twice as much. Without it a good archive would be refused.
static bool has_room(const char *folder) {
    struct statvfs info;
    return (statvfs(folder, &info) == 0 &&
            (double)info.f_bavail * (double)info.f_frsize > 2.0 * EXTRACT_MAX_BYTES &&
            (info.f_files == 0 || info.f_favail > EXTRACT_MAX_FILES)) ||
           check_fail("there is not enough room for an archive in %s", folder);
}

Extracted archive_unpack(const Jail *jail, const char *archive, const char *folder) {
    return has_room(folder) ? jail_extract(jail, archive, folder) : EXTRACT_FAULT;
}
