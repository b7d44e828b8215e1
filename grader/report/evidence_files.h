// Pictures of what failed, as files.
#pragma once

#include "diagnose/result.h"

#include <stdbool.h>

// Writes the pictures that evidence_attach made as PNG to folder/NN/CHECK-yours.png and so on. Makes no
// folder when nothing failed.
bool evidence_write(const LabResult *result, const char *folder);
