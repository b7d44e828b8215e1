// What a student of lab 6 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

static double visibility_at_edge(const double *given) {
    const double t = given[0];
    return 0.5 + (t * sqrt(1 - t * t) + asin(t)) / acos(-1);
}

static double nearest_outer_sample(const double *given) {
    return sqrt(1 - 2 / given[0]);
}

static double visibility_behind(const double *given) {
    return 1 - given[0] * given[0];
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "A straight edge crosses the disc of samples {t} of its radius beside its "
     "middle, and the larger part of the disc is lit. Which visibility is right "
     "there?",
     "The handout's V(t), with the arc sine in radians.",
     {{"t", 0.1, 0.05, 15}},
     visibility_at_edge,
     0.02},
    {LAB_ID,
     "The samples have 4 columns and {rows} rows of cells. How far from the middle of"
     " the disc do the first eight samples lie at least, as a part of its radius?",
     "Eight samples fill the first two rows, so v is at least 1 - 2/rows, and the "
     "distance is its root.",
     {{"rows", 4, 1, 13}},
     nearest_outer_sample,
     0.02},
    {LAB_ID,
     "A round caster hides the middle of the disc; its radius is {part} of the "
     "disc's. Which visibility is right there?",
     "The share of the disc's area that is not hidden.",
     {{"part", 0.2, 0.05, 12}},
     visibility_behind,
     0.02},
    {0}};
