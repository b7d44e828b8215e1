// What a student of lab 2 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

static double distance_of_depth(const double *given) {
    const double z = 2 * given[2] - 1;
    return 2 * given[0] * given[1] / (given[1] + given[0] - z * (given[1] - given[0]));
}

static double half_of_depths(const double *given) {
    return 2 * given[0] * given[1] / (given[0] + given[1]);
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "A camera's near plane is {near} away and its far plane {far}. Its depth texture"
     " holds {depth}, which lies between 0 and 1. How far before the camera is what "
     "is seen there?",
     "First from the depth to z_ndc, which runs from -1 to 1; then the handout's "
     "formula for d.",
     {{"near", 0.2, 0.1, 9}, {"far", 20, 5, 9}, {"depth", 0.6, 0.03, 12}},
     distance_of_depth,
     0.02},
    {LAB_ID,
     "Another camera has the near plane {near} and the far plane {far}. Before which "
     "distance do half of all its depths lie?",
     "The depth there is one half, and so z_ndc is 0.",
     {{"near", 0.2, 0.1, 9}, {"far", 20, 5, 9}},
     half_of_depths,
     0.02},
    {0}};
