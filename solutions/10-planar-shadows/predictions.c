// What a student of lab 10 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

static double penumbra_width(const double *given) {
    return given[0] * given[2] / (given[1] - given[2]);
}

static double umbra_width(const double *given) {
    return (given[0] * given[3] - given[2] * given[1]) / (given[3] - given[1]);
}

static double largest_error(const double *given) {
    return 1 / (2 * given[0]);
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "A square lamp with sides of {side} hangs {lamp} over the floor, and an edge "
     "{height} over it. How wide is the penumbra that the edge throws?",
     "Seen from the edge, the penumbra is to its height as the lamp is to its height "
     "over the edge.",
     {{"side", 0.4, 0.1, 9}, {"lamp", 4, 0.5, 9}, {"height", 0.8, 0.2, 8}},
     penumbra_width,
     0.02},
    {LAB_ID,
     "A level square plate with sides of {plate} hangs {height} over the floor, "
     "straight under a lamp with sides of {side} that hangs {lamp} over it. How wide "
     "is its umbra?",
     "(a H - s h) / (H - h): the shadow of a point lamp less one penumbra.",
     {{"plate", 1.2, 0.2, 8}, {"height", 0.8, 0.2, 6}, {"side", 0.4, 0.1, 7}, {"lamp", 4, 0.5, 9}},
     umbra_width,
     0.02},
    {LAB_ID,
     "You cut the lamp into {n} x {n} small ones. How much of the lamp's light, as a "
     "part of 1, is wrong in the penumbra at most?",
     "The light has n + 1 even levels; half a level is wrong at most.",
     {{"n", 2, 1, 9}},
     largest_error,
     0.02},
    {0}};
