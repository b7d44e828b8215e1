// What a student of lab 4 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

static double least_bias(const double *given) {
    return given[1] / given[0] / 2 * tan(prediction_radians(given[3])) / given[2];
}

static double gap_width(const double *given) {
    return given[0] * given[1] * sin(prediction_radians(given[2]));
}

static double tip_shift(const double *given) {
    const double theta = prediction_radians(given[2]);
    return given[0] * given[1] * sin(theta) * tan(theta);
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "A sun's map of {texels} texels from edge to edge covers {width} units. Its far "
     "plane lies {range} behind its near plane. A floor's normal is {angle} degrees "
     "beside the light, and its slope runs along a side of the map. What is the least"
     " constant bias, as a depth of the map, that leaves no acne?",
     "s is the width divided by the texels and psi is 0; b0 is a distance, and "
     "divided by f - n it is a depth of the map.",
     {{"texels", 60, 20, 10}, {"width", 8, 2, 8}, {"range", 8, 1, 9}, {"angle", 30, 5, 9}},
     least_bias,
     0.02},
    {LAB_ID,
     "The constant bias is {bias}, as a depth of the map; the far plane lies {range} "
     "behind the near one. The light comes from {angle} degrees beside the floor's "
     "normal. How wide is the lit gap at the foot of a very thin wall that stands "
     "across it?",
     "The bias in world units is bias times (f - n); the gap is that times the sine "
     "of the angle.",
     {{"bias", 0.04, 0.005, 9}, {"range", 8, 1, 9}, {"angle", 35, 5, 7}},
     gap_width,
     0.02},
    {LAB_ID,
     "With a normal offset of k = {k}, a texel {texel} wide and the light {angle} "
     "degrees beside the floor's normal: how far does the tip of a wall's shadow "
     "move?",
     "The offset is k s times the sine of the angle; the tip moves by the offset "
     "times the tangent.",
     {{"k", 2, 1, 8}, {"texel", 0.02, 0.005, 8}, {"angle", 35, 5, 6}},
     tip_shift,
     0.02},
    {0}};
