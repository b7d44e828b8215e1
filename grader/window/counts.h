// The stage "stencil counts" of common/frame_view.h in colours that are easy to tell apart, and their legend.
// Pure.
#pragma once

#include "scene/image.h"

#include <stdbool.h>
#include <stdint.h>

// A number of volumes around a point, as the stage shows it and as the window does.
typedef struct CountColor {
    const char *name; // "0", "4 and more", "-1"
    uint8_t stage[3], shown[3];
} CountColor;

// Is this the view that shows counts?
bool counts_is_view(const char *view);

// The i-th entry of the legend; NULL past the last.
const CountColor *counts_color(int i);

// The count that a colour of the stage means; NULL for a colour that means none.
const CountColor *counts_find(const uint8_t rgb[3]);

// Recolours the stage's picture; what means no count stays as it is.
void counts_recolor(Image *picture);
