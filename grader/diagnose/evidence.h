// Pictures of what failed.
#pragma once

#include "diagnose/result.h"

#include <stdbool.h>

// Makes yours, reference, difference (too bright in yellow, too dark in blue) and crop of each failed check
// of which frames were drawn, from its worst variant. With `hidden` the whole pictures are shrunk to a third,
// so that only the crop shows pixels as they are. False with a message.
bool evidence_attach(LabResult *result, const Exam *exam, bool hidden);
