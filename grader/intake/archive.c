#include "intake/archive.h"

#include "scene/check.h"
#include "jail/extract.h"

#include <string.h>
#include <sys/statvfs.h>
#include <unistd.h>

// Room for what an archive may hold, and twice as much. Without it a good archive would be refused.
static bool has_room(const char *folder) {
    struct statvfs info;
    return (statvfs(folder, &info) == 0 &&
            (double)info.f_bavail * (double)info.f_frsize > 2.0 * EXTRACT_MAX_BYTES &&
            (info.f_files == 0 || info.f_favail > EXTRACT_MAX_FILES)) ||
           check_fail("there is not enough room for an archive in %s", folder);
}

Unpacked archive_unpack(const Jail *jail, const char *archive, const char *folder) {
    if (access(archive, R_OK) != 0) {
        check_fail("the archive cannot be read");
        return UNPACK_FAILED;
    }
    if (!has_room(folder))
        return UNPACK_FAILED;
    if (jail_extract(jail, archive, folder))
        return UNPACK_OK;
    char text[1200] = "the archive";
    size_t length = strlen(archive);
    if (strncmp(check_message(), archive, length) != 0 || !has_room(folder))
        return UNPACK_FAILED; // what is wrong with an archive begins with its name
    check_append(text, sizeof text, "%.1000s", check_message() + length);
    check_clear();
    check_fail("%s", text);
    return UNPACK_REFUSED;
}
