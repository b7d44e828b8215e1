// Opens an archive that a student handed in.
#pragma once

#include "jail/extract.h"

// Is it the name of an archive that archive_unpack knows, by its ending?
bool archive_is_name(const char *name);

// The length of the name without such an ending; of the whole name when it has none.
size_t archive_stem(const char *name);

// Unpacks the archive into the folder, which is there and empty, with limits on time, sizes and the number of
// files, where there is room for what they allow (see jail_extract).
Extracted archive_unpack(const Jail *jail, const char *archive, const char *folder);
