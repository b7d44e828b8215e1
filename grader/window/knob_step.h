// What a key does to a knob. Pure; the knob's description is clean (see description.h).
#pragma once

#include "protocol/protocol.h"

#include <stdbool.h>

// The value after a step up or down (`direction` 1 or -1), within the range. Knobs whose range and default
// are whole numbers stay whole: by 1 in small ranges, else doubled and halved to powers of two. Others go by
// a twentieth of the range, or by half an octave where it spans two decades. A fine step is 1, or a tenth of
// that.
float knob_step(const struct KnobText *knob, float value, int direction, bool fine);

// The name of the choice nearest to the value; "" where it has none.
const char *knob_choice(const struct KnobText *knob, float value);

// "256 texels  (16..2048)"; of a knob that chooses its words: "1: z-fail  (z-pass, z-fail)".
void knob_text(const struct KnobText *knob, float value, char *text, size_t size);
