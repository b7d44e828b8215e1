// Opens an archive that a student handed in.
#pragma once

#include "jail/jail.h"

#include <stdbool.h>

typedef enum Unpacked { UNPACK_OK, UNPACK_REFUSED, UNPACK_FAILED } Unpacked;

// Unpacks the archive into the folder, which is there and empty, with limits on time, sizes and the number of
// files. Refused: with a message that says what is wrong with the archive. Failed: with a message, a fault of
// ours.
Unpacked archive_unpack(const Jail *jail, const char *archive, const char *folder);
