// Methods that no lab has yet.
#include "stability/row.h"

const Row rows_later[] = {
    {31, "light maps", "light kept in the texels of the scene",
     "texels a unit; the seam between wall and floor",
     "The shadow's edge is off in proportion to the texel. Light leaks through a seam by a texel at most, "
     "and "
     "not at all where the charts are padded.",
     "closed form", NULL},
    {0},
};
