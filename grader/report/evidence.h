// Pictures of what failed.
#pragma once

#include "result.h"

#include <stdbool.h>

// Makes yours, reference, difference (too bright in yellow, too dark in blue) and crop of each failed check
// of which frames were drawn, from its worst variant. False with a message.
bool evidence_attach(LabResult *result, const Exam *exam);

// Writes them as PNG to folder/NN/CHECK-yours.png and so on. Makes no folder when nothing failed.
bool evidence_write(const LabResult *result, const char *folder);
