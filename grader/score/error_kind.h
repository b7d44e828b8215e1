// Names the kind of a difference between two pictures, for what no catalogue of mistakes holds. No GL.
#pragma once

#include "scene/image.h"

#include <stdbool.h>
#include <stddef.h>

// What the picture shows: only words that fit it are used.
typedef enum ErrorView {
    ERROR_VIEW_VALUES,     // a depth map, an atlas, counts, or a scene without shadows
    ERROR_VIEW_VISIBILITY, // shadows, but no ambient light
    ERROR_VIEW_SHADED      // shadows and ambient light
} ErrorView;

// Writes what is wrong with `yours` and where, for instance "false shadow: too dark where light should be; 12
// % of the picture, mostly at the lower left". Both pictures have one size. Returns the kind alone, a
// constant without the numbers of these pictures: it is the same for all pictures with this fault.
const char *error_kind(char *text, size_t size, const Image *yours, const Image *reference, ErrorView view);

// Has the picture only one colour? Then nothing was drawn, and it resembles too much to blame one mistake.
bool error_kind_is_plain(const Image *image);

// Are the edges of the reference's shadow, where the picture without the shadow has none, lost in `yours`? So
// it is where all is lit, or all dark: many causes draw that. False where the reference has no such edges.
bool error_kind_lost_edges(const Image *yours, const Image *reference, const Image *without);
