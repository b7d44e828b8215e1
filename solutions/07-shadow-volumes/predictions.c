// What a student of lab 7 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

static double count_by_z_pass(const double *given) {
    return given[1] - given[2];
}

static double count_by_z_fail(const double *given) {
    return given[0] + given[1] - given[2];
}

static double distance_of_depth(const double *given) {
    return given[0] / (1 - given[1]);
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "The eye stands in {around} shadow volumes. On its way to a point of the floor, "
     "its ray enters {in} more and leaves {out}. What does z-pass count at the point?",
     "z-pass knows only the faces between the near plane and the point: front faces +"
     " 1, back faces - 1.",
     {{"around", 1, 1, 4}, {"in", 3, 1, 4}, {"out", 0, 1, 3}},
     count_by_z_pass,
     0},
    {LAB_ID,
     "The same, another ray: the eye stands in {around} volumes, the ray enters {in} "
     "more and leaves {out} before it meets the floor. What does z-fail count there?",
     "z-fail is right wherever the eye stands: it counts the volumes that hold the "
     "point.",
     {{"around", 1, 1, 4}, {"in", 1, 1, 4}, {"out", 0, 1, 2}},
     count_by_z_fail,
     0},
    {LAB_ID,
     "The camera has no far plane, and its near plane is {near} away. At which "
     "distance is the depth, from 0 to 1, {depth}?",
     "Without a far plane z_ndc is (d - 2 n)/d, and the depth is half of it and one "
     "half more.",
     {{"near", 0.1, 0.05, 9}, {"depth", 0.6, 0.02, 16}},
     distance_of_depth,
     0.02},
    {0}};
