// Kinds of difference that hold for a picture as a whole: one simple change makes it the reference. No GL.
#pragma once

#include "scene/image.h"

#include <stdbool.h>

// A constant: "mirrored: left and right are exchanged", "inverted: ...", "a factor: ...", "one channel only:
// ..."; NULL when no such change explains most of the `wrong` pixels. Both pictures have one size.
const char *whole_kind(const Image *yours, const Image *reference, double wrong);

// Is the picture right on average over small blocks, but not pixel for pixel, as with other random numbers?
bool whole_is_other_noise(const Image *yours, const Image *reference);
