// What a student of lab 12 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

static double irradiance(const double *given) {
    return given[0] * given[1] / pow(hypot(given[1], given[2]), 3);
}

static double last_level(const double *given) {
    return floor(log2((given[0] + 1) / 1.5));
}

static double percent_wrong(const double *given) {
    return 100 * 3 * given[0] * given[0] / (4 * given[1] * given[1]);
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "A lamp of the colour {color} hangs {height} over the floor. How much light E "
     "falls on the floor {beside} beside the point straight under it?",
     "r is the way from the lamp, and the cosine of theta is the height divided by r.",
     {{"color", 2, 0.5, 13}, {"height", 1, 0.25, 9}, {"beside", 0.5, 0.25, 9}},
     irradiance,
     0.02},
    {LAB_ID,
     "Each chart has {padding} luxels of padding. Which is the last mipmap level that"
     " may be used?",
     "On level l the filter reaches up to 3/2 times 2 to the power l, less 1, luxels "
     "outside: the largest l for which the padding is enough.",
     {{"padding", 1, 1, 16}},
     last_level,
     0},
    {LAB_ID,
     "Luxels have sides of {side}, and a lamp hangs {height} over them. How many "
     "percent of E is wrong straight under it at most, for they are blended by "
     "straight lines?",
     "100 times 3 s^2 / (4 h^2).",
     {{"side", 0.1, 0.05, 9}, {"height", 1, 0.25, 9}},
     percent_wrong,
     0.02},
    {0}};
