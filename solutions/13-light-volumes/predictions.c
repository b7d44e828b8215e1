// What a student of lab 13 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

static double light_of_dust(const double *given) {
    return given[0] * (1 - exp(-given[1] * given[2])) / given[1];
}

static double light_of_shadow(const double *given) {
    const double left = exp(-given[1] * given[2]);
    return given[0] * left * (1 - exp(-given[1] * given[3])) / given[1];
}

static double error_at_border(const double *given) {
    return given[2] * given[1] / given[0] / 2;
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "Dust scatters s = {s} and takes a = {a} of the light on each unit of its way. "
     "All of it is lit by a light of the brightness 1. How much does a ray bring that"
     " meets a surface {distance} away? (L, without the quarter that picture.frag "
     "takes)",
     "s G(D), with G(D) = (1 - e^(-a D)) / a.",
     {{"s", 0.05, 0.01, 11}, {"a", 0.05, 0.01, 11}, {"distance", 4, 0.5, 13}},
     light_of_dust,
     0.02},
    {LAB_ID,
     "In dust of s = {s} and a = {a} a ray enters a shadow {enter} before the eye and"
     " is in it for {inside}. How much light does the shadow take from it?",
     "s (G(t1) - G(t0)), where the ray enters at t0 and leaves at t1.",
     {{"s", 0.05, 0.01, 11}, {"a", 0.05, 0.01, 11}, {"enter", 2, 0.25, 9}, {"inside", 1, 0.25, 9}},
     light_of_shadow,
     0.02},
    {LAB_ID,
     "You march {steps} steps over a ray of the length {distance}, in dust of s = {s}"
     " and no losses (a = 0). How much light can one border of a shadow cost at most,"
     " or bring?",
     "The border is missed by up to half a step, and a step brings s times its "
     "length.",
     {{"steps", 8, 4, 9}, {"distance", 4, 0.5, 13}, {"s", 0.05, 0.01, 11}},
     error_at_border,
     0.02},
    {0}};
