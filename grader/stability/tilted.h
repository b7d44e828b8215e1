// A wall under a directional light that is tilted from its normal: acne and its cures have closed forms
// there.
#pragma once

#include "truth/closed_scenes.h"

// Depth range of the light, world units.
#define TILTED_NEAR 4.0F
#define TILTED_FAR 16.0F

// A wall, seen straight on, that fills a picture of this aspect, 7.28 world units wide. The light is at the
// angle theta from the wall's normal, and the wall's slope in the map has the azimuth psi (degrees, both; psi
// = 0: along the map's x axis, and all rows of the picture are alike). The map is 2 * half_size wide.
Scene tilted_wall(double theta, double psi, float half_size, double aspect);

// tan theta * (|cos psi| + |sin psi|): how much the wall's depth in the map of light 0 changes from the
// middle of a texel to its worst corner, in half texels.
double tilted_slope(const Scene *scene);

// Acne without filter: the share of a bare wall that is dark under a bias of r times the least one that ends
// it. A texel's depth is that of its middle, and in it the depth differs by a sum of two uniform numbers, of
// which |cos psi| and |sin psi| are the weights: at psi = 0 (1 - r) / 2, at 45 degrees (1 - r)^2 / 2.
double tilted_acne(double r, double psi);
