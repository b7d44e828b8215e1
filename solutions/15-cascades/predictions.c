// What a student of lab 15 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

enum { SLICES = 4 };

static double where_it_ends(const double *given) {
    const double near_plane = given[0], far_plane = given[1], lambda = given[2], share = given[3] / SLICES;
    return lambda * near_plane * pow(far_plane / near_plane, share) +
           (1 - lambda) * (near_plane + (far_plane - near_plane) * share);
}

static double side_of_texel(const double *given) {
    const double begin = given[0], end = begin + given[1], k = given[2], texels = given[3];
    const double centre = fmin((begin + end) * (1 + k * k) / 2, end);
    return 2 * hypot(end - centre, end * k) / (texels - 2);
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "The camera's near plane is at {near}, its far plane at {far}; there are 4 slices, and "
     "lambda is {lambda}. The nearest slice is the first. How far before the eye does slice "
     "number {which} end?",
     "Take the formula of the borders with this number as i, and m = 4.",
     {{"near", 0.5, 0.25, 5}, {"far", 20, 10, 7}, {"lambda", 0.3, 0.1, 5}, {"which", 1, 1, 3}},
     where_it_ends,
     0.02},
    {LAB_ID,
     "A slice begins at {begin} and is {long} long; the picture's corners are {k} from the axis for each "
     "unit "
     "before the eye. Its map has {texels} texels along a side. How long is a texel's side in the world?",
     "First the sphere's centre (mind the min) and its radius r; the map is 2 h wide, and h = r N / (N - 2).",
     {{"begin", 1, 1, 5}, {"long", 4, 2, 5}, {"k", 0.4, 0.1, 9}, {"texels", 128, 128, 4}},
     side_of_texel,
     0.02},
    {0}};
