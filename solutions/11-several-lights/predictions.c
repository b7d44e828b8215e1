// What a student of lab 11 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

static double depth_in_cube(const double *given) {
    const double m = fmax(given[0], fmax(given[1], given[2]));
    return 20 * (1 - given[3] / m) / (20 - given[3]);
}

static double penumbra_width(const double *given) {
    return 2 * given[0] * given[2] / (given[1] - given[2]);
}

static double layers(const double *given) {
    return given[0] + given[1] * given[2] * given[2];
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "A point lies {x} right of a lamp, {y} above it and {z} before it. The planes of"
     " its cube's faces are {near} and 20. Which depth, from 0 to 1, do you compare "
     "with the cube?",
     "m is the largest of the three; the face that looks that way sees the point, and"
     " its projection makes the depth.",
     {{"x", 1, 0.2, 8}, {"y", 1.1, 0.2, 8}, {"z", 1.3, 0.3, 8}, {"near", 0.5, 0.1, 6}},
     depth_in_cube,
     0.02},
    {LAB_ID,
     "A wide light with the extent {extent} (half its side) is {lamp} before a wall "
     "and looks straight at it; a plate's edge is {height} before the wall. How wide "
     "is the penumbra?",
     "The side is twice the extent; the rest is a matter of similar triangles, as in "
     "lab 10.",
     {{"extent", 0.2, 0.05, 11}, {"lamp", 5, 0.5, 8}, {"height", 1, 0.25, 9}},
     penumbra_width,
     0.02},
    {LAB_ID,
     "A scene has one lamp in its middle. Suns: {suns}. Wide lights: {wide}, of {n} x "
     "{n} small lamps each. How many layers of the array of maps are drawn?",
     "A sun has one map, a wide light one for each small lamp, and the lamp in the "
     "middle has its cube.",
     {{"suns", 1, 1, 3}, {"wide", 1, 1, 4}, {"n", 2, 1, 2}},
     layers,
     0},
    {0}};
