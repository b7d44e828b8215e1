// What a student of lab 3 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

static double texel_width(const double *given) {
    return 2 * given[2] * tan(prediction_radians(given[1] / 2)) / given[0];
}

static double shadow_width(const double *given) {
    return given[0] * given[2] / (given[2] - given[1]);
}

static double shadow_length(const double *given) {
    return given[1] * tan(prediction_radians(given[0]));
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "A spot light's map has {texels} texels from edge to edge and covers {angle} "
     "degrees. The light looks straight at a wall {distance} away. How wide is a "
     "texel on the wall?",
     "Half of the map's width on the wall is the distance times the tangent of half "
     "the angle.",
     {{"texels", 100, 20, 16}, {"angle", 40, 5, 11}, {"distance", 4, 0.5, 13}},
     texel_width,
     0.02},
    {LAB_ID,
     "A square plate with sides of {side} hangs level at the height {height} over a "
     "floor, straight under a lamp at the height {lamp}. How wide is its shadow?",
     "The light's rays are straight: the plate is to its distance from the lamp as "
     "the shadow is to the lamp's height.",
     {{"side", 0.5, 0.1, 11}, {"height", 1, 0.2, 8}, {"lamp", 4, 0.5, 8}},
     shadow_width,
     0.02},
    {LAB_ID,
     "The sun stands {angle} degrees beside straight above. How long is the shadow of"
     " a post {height} high?",
     "The post and its shadow are the sides of a right angle; the sun's angle lies at"
     " the post's tip.",
     {{"angle", 20, 5, 10}, {"height", 1, 0.25, 9}},
     shadow_length,
     0.02},
    {0}};
