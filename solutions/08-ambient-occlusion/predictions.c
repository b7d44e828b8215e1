// What a student of lab 8 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

static double beside_wall(const double *given) {
    return (1 - given[1] / hypot(given[0], given[1])) / 2;
}

static double under_disc(const double *given) {
    return given[0] * given[0] / (given[0] * given[0] + given[1] * given[1]);
}

static double error_of_rays(const double *given) {
    return sqrt(given[0] * (1 - given[0]) / given[1]);
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "How much of the sky's light does an endless wall {height} high hide from a "
     "point on the floor {beside} before it? (A, from 0 to 1)",
     "The formula stands in the handout's question.",
     {{"height", 0.5, 0.25, 10}, {"beside", 0.4, 0.2, 9}},
     beside_wall,
     0.02},
    {LAB_ID,
     "A round disc of the radius {radius} hangs level over the floor, {height} above "
     "it. What is A on the floor straight under its middle?",
     "The directions that meet it lie evenly in a circle of the unit disc. Its radius"
     " is the sine of the angle from the normal to the disc's edge.",
     {{"radius", 0.5, 0.1, 11}, {"height", 0.5, 0.1, 11}},
     under_disc,
     0.02},
    {LAB_ID,
     "Where A is {occlusion}, how large is the error of {rays} rays at most?",
     "The root of A (1 - A) / rays.",
     {{"occlusion", 0.2, 0.05, 13}, {"rays", 16, 16, 12}},
     error_of_rays,
     0.02},
    {0}};
