// What a student of lab 16 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

static double variance(const double *given) {
    const double share = given[0], gap = given[2] - given[1];
    return share * (1 - share) * gap * gap;
}

static double light_that_bleeds(const double *given) {
    const double share = given[0], beyond = given[2] + share * given[1],
                 spread = variance((const double[]){share, 0, given[1]});
    return spread / (spread + beyond * beyond);
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "A filter sees an occluder at the depth {occluder} in a share of {share} of its texels, "
     "and the receiver at the depth {receiver} in the others. How large is the variance?",
     "The mean of the squares less the square of the mean; it comes to q (1 - q) times "
     "the square of the difference.",
     {{"share", 0.2, 0.1, 7}, {"occluder", 0.2, 0.05, 5}, {"receiver", 0.6, 0.05, 7}},
     variance,
     0.02},
    {LAB_ID,
     "A receiver is wholly dark: an occluder lies {lower} before it. A second one lies "
     "{upper} before the first, and covers a share of {share} of the filter. (All along "
     "the light.) How much light, as a part of 1, does the receiver get by the bound, "
     "without a cut?",
     "p = q (1 - q) a^2 / (q (1 - q) a^2 + (b + q a)^2): the upper gap is a, the lower "
     "one b.",
     {{"share", 0.2, 0.1, 6}, {"upper", 0.8, 0.2, 9}, {"lower", 0.4, 0.1, 9}},
     light_that_bleeds,
     0.02},
    {0}};
