// Names the kind of a difference between two pictures, for what no catalogue of mistakes holds. No GL.
#pragma once

#include "scene/image.h"

#include <stdbool.h>
#include <stddef.h>

// Writes what is wrong with `yours` and where, for instance "false shadow: too dark where light should be; 12
// % of the picture, mostly at the lower left". Both pictures have one size. Returns the kind alone, a
// constant without the numbers of these pictures: it is the same for all pictures with this fault.
const char *error_kind(char *text, size_t size, const Image *yours, const Image *reference);

// Has the picture only one colour? Then nothing was drawn, and it resembles too much to blame one mistake.
bool error_kind_is_plain(const Image *image);
