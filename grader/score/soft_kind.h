// Kinds of error in which only the sharpness of a picture is wrong. No GL.
#pragma once

#include "scene/image.h"

#include <stdbool.h>

// Blurred, or a penumbra that is too wide or too narrow: one picture is the other one, blurred by some box.
// NULL when it is none of these. Constants, in words for a view with shadows or without.
const char *soft_kind(const Image *yours, const Image *reference, bool shadows);

// Is it right on the whole, but with edges in other steps, coarser or finer? NULL when not.
const char *coarse_kind(const Image *yours, const Image *reference);
