// What stands in the window's picture, from mine and the other one. Pure.
#pragma once

#include "score/difference.h"
#include "scene/image.h"

typedef enum Show { SHOW_MINE, SHOW_REFERENCE, SHOW_SPLIT, SHOW_DIFFERENCE, SHOW_TRUTH, SHOW_COUNT } Show;

// Writes `out`, made again when its size differs. SPLIT has mine left of the column split * width, the other
// one from there on; DIFFERENCE is difference_mark's, with its counts; the rest is a copy of mine (SHOW_MINE)
// or of the other one. A picture without pixels, or of another size than the leading one, is dark grey. When
// neither has pixels, `out` stays.
Difference compose(Image *out, Show show, const Image *mine, const Image *other, float split);

// First column of the other picture, 0..width.
int compose_column(float split, int width);
