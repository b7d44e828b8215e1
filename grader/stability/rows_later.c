// Methods that no lab has yet.
#include "stability/row.h"

const Row rows_later[] = {
    {30, "planar shadows", "casters flattened onto the floor",
     "overlapping casters; a caster above the light or below the floor; the offset from the floor",
     "Two casters darken their common shadow twice unless the stencil lets each pixel through once. The "
     "projection's w is P.L - P.v for the plane P, the light L and the vertex v, and is right for 0 < P.v < "
     "P.L "
     "only: what lies above the light or below the floor casts a false shadow unless it is clipped. Without "
     "an "
     "offset, shadow and floor fight for each pixel.",
     "closed form", NULL},
    {31, "light maps", "light kept in the texels of the scene",
     "texels a unit; the seam between wall and floor",
     "The shadow's edge is off in proportion to the texel. Light leaks through a seam by a texel at most, "
     "and "
     "not at all where the charts are padded.",
     "closed form", NULL},
    {0},
};
