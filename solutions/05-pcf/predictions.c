// What a student of lab 5 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

static double ramp_width(const double *given) {
    return (2 * given[2] + 1) * given[1] / given[0];
}

static double least_bias(const double *given) {
    return (given[2] + 1) * (given[0] + given[1]);
}

static double visibility_of_two(const double *given) {
    return (2 - given[0]) / 3;
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "A map of {texels} texels from edge to edge covers {width} units, and you filter"
     " with a box of radius {radius} of linear comparisons. How wide, in units, is "
     "the ramp from dark to lit at a straight edge along the map?",
     "The ramp is 2 k + 1 texels wide; a texel is the width divided by the texels.",
     {{"texels", 64, 16, 9}, {"width", 4, 1, 9}, {"radius", 1, 1, 4}},
     ramp_width,
     0.02},
    {LAB_ID,
     "From texel to texel a plane's depth grows by {x} along x and by {y} along y. "
     "You filter it with a box of radius {radius} of linear comparisons. What is the "
     "least bias that keeps the plane from shading itself?",
     "The farthest tap is radius texels away, and a linear comparison reaches one "
     "texel more; both slopes count.",
     {{"x", 0.001, 0.0005, 7}, {"y", 0.002, 0.0005, 7}, {"radius", 1, 1, 4}},
     least_bias,
     0.02},
    {LAB_ID,
     "Three linear comparisons, one texel apart, lie on four texels: lit, lit, dark, "
     "dark. The fraction f is {f}. Which visibility do they give?",
     "The four texels weigh (1 - f)/3, 1/3, 1/3 and f/3.",
     {{"f", 0.1, 0.05, 17}},
     visibility_of_two,
     0.02},
    {0}};
