// Kinds of difference that hold for a picture as a whole: one simple change makes it the reference. No GL.
#pragma once

#include "scene/image.h"

// A constant: "mirrored: left and right are exchanged", "inverted: ...", "a factor: ...", "one channel only:
// ..."; NULL when no such change explains most of the `wrong` pixels. Both pictures have one size.
const char *whole_kind(const Image *yours, const Image *reference, double wrong);

// "right on average, ...": the same in each small block, though the pixels differ; NULL when it is not so.
const char *average_kind(const Image *yours, const Image *reference);
