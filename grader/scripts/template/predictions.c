// What a student of lab @N@ works out before it runs, by the formulas of the handout.
#include "predict/prediction.h"

static double reflected(const double *given) {
    return given[0] * given[1];
}

static double half(const double *given) {
    return given[0] / 2;
}

const Prediction LAB_TABLE[] = {{LAB_ID,
                                 "The lamp's brightness is {lamp}, and a surface that looks straight at it "
                                 "reflects {share} of it. How bright does "
                                 "it look without any other light?",
                                 "Brightness times what is reflected.",
                                 {{"lamp", 0.4, 0.1, 7}, {"share", 0.3, 0.05, 12}},
                                 reflected,
                                 0.02},
                                {LAB_ID,
                                 "The knob halves the brightness {lamp}. What is left?",
                                 "Half of it.",
                                 {{"lamp", 0.4, 0.1, 7}},
                                 half,
                                 0.02},
                                {0}};
