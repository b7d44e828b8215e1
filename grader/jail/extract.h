// Opens an untrusted archive.
#pragma once

#include "jail/extract_protocol.h" // the limits
#include "jail/jail.h"

#include <stdbool.h>

typedef enum Extracted {
    EXTRACT_OK,
    EXTRACT_BAD_ARCHIVE, // who made the archive is to blame
    EXTRACT_FAULT        // the machine or we are: no room, a jail that does not start
} Extracted;

// Writes the regular files of a .zip or .tar (also gzip, bzip2, xz, zstd) into the existing, empty folder.
// The archive is read in the jail, which gets its bytes and gives back names and bytes: it has no access to
// any folder, and we make plain files and folders of plain names only. Bad, with a message "the archive ...",
// when it is none, is too large, or holds a link, a device, an absolute path, "..", or one name twice; then
// the folder holds a part of it. A fault comes with a message, too.
Extracted jail_extract(const Jail *jail, const char *archive, const char *folder);
