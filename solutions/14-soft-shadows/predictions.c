// What a student of lab 14 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

// The map sees 2 r tan(alpha) at the distance r.
static double width_of_map(double distance, double angle) {
    return 2 * distance * tan(prediction_radians(angle) / 2);
}

static double side_of_kernel(const double *given) {
    const double side = given[0], receiver = given[1], blocker = given[2];
    return side * (receiver - blocker) / receiver / width_of_map(blocker, given[3]);
}

// k(b) = 1 / m, solved for the height r - b.
static double height_of_texel(const double *given) {
    const double side = given[0], receiver = given[1],
                 texel = width_of_map(receiver, given[2]) / given[3]; // on the receiver
    return receiver * texel / (side + texel);
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "A square lamp has sides of {side}. The receiver is {receiver} away from it, a "
     "blocker {blocker}, both along the light's axis; the map's whole angle is {angle} "
     "degrees. How large is the kernel, as a part of the map's side?",
     "S (r - b) / (2 r b tan(alpha)), and alpha is half of the map's angle.",
     {{"side", 0.5, 0.1, 11}, {"receiver", 9, 0.5, 7}, {"blocker", 4, 0.5, 8}, {"angle", 40, 4, 6}},
     side_of_kernel,
     0.02},
    {LAB_ID,
     "A square lamp has sides of {side}, and the receiver is {receiver} away from it. "
     "The map's whole angle is {angle} degrees, and it has {texels} x {texels} texels. How "
     "far before the receiver must a blocker be, for the kernel to be one texel wide?",
     "Set k(b) equal to 1 over the number of texels along a side, and solve it for b. "
     "Asked for is r - b.",
     {{"side", 0.5, 0.1, 11}, {"receiver", 9, 0.5, 7}, {"angle", 40, 4, 6}, {"texels", 256, 128, 7}},
     height_of_texel,
     0.02},
    {0}};
