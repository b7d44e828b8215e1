// What a student of lab 9 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

static double least_stretch(const double *given) {
    return given[1] / (given[0] - given[1]);
}

static double silhouette_edges(const double *given) {
    return given[0] == 1 ? 4 : 6;
}

static double volumes_around_eye(const double *given) {
    return given[0] + given[1];
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "A lamp hangs {lamp} over the floor, and the lit corner of a caster {height} "
     "over it. What is the least stretch k with which the corner's shadow reaches the"
     " floor?",
     "k times the way from the lamp to the corner must lead down from the corner to "
     "the floor: compare the heights.",
     {{"lamp", 4, 0.5, 9}, {"height", 0.5, 0.25, 10}},
     least_stretch,
     0.02},
    {LAB_ID,
     "A lamp sees {faces} faces of a box. How many edges has its silhouette?",
     "Draw it: the edges between a face that it sees and one that it does not.",
     {{"faces", 1, 1, 3}},
     silhouette_edges,
     0},
    {LAB_ID,
     "Between the eye and the lamp stand {boxes} boxes and {sheets} sheets, one "
     "behind the other, each of them across the way. With which number must z-pass "
     "begin?",
     "On its way to the light the eye looks through the back of one lit triangle for "
     "each of them.",
     {{"boxes", 1, 1, 6}, {"sheets", 0, 1, 5}},
     volumes_around_eye,
     0},
    {0}};
