// What a student of lab 1 works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

#include <math.h>

static double diffuse_red(const double *given) {
    return given[0] * (given[1] + given[2] * cos(prediction_radians(given[3])));
}

static double highlight(const double *given) {
    return given[0] * given[1] * pow(cos(prediction_radians(given[3])), given[2]);
}

static double posterised(const double *given) {
    return floor(4 * given[0] + 0.5) / 4;
}

const Prediction LAB_TABLE[] = {
    {LAB_ID,
     "A surface of the red {red} stands under the ambient light {ambient}. A lamp of "
     "the brightness {lamp} lights it from {angle} degrees beside its normal. Which "
     "red does the diffuse model give it?",
     "The ambient part is ambient times red; the lamp adds its brightness times red "
     "times the cosine of the angle.",
     {{"red", 0.4, 0.05, 10}, {"ambient", 0.1, 0.02, 8}, {"lamp", 0.5, 0.05, 8}, {"angle", 20, 5, 10}},
     diffuse_red,
     0.02},
    {LAB_ID,
     "Phong's model adds a highlight. The lamp's brightness is {lamp}, the specular "
     "reflectance {specular}, the shininess {shininess}, and the eye is {off} degrees"
     " beside the reflected ray. How much is added?",
     "Brightness times reflectance times the cosine of that angle to the power of the"
     " shininess.",
     {{"lamp", 0.5, 0.05, 8}, {"specular", 0.4, 0.05, 10}, {"shininess", 8, 4, 7}, {"off", 6, 1, 12}},
     highlight,
     0.02},
    {LAB_ID,
     "A colour's channel is {value}. What is it once it is posterised?",
     "Four times the value plus one half, rounded down, then divided by four.",
     {{"value", 0.14, 0.04, 19}},
     posterised,
     0},
    {0}};
