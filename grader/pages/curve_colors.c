#include "pages/curve_colors.h"

const char *const curve_colors[CURVE_COLORS] = {"#0072b2", "#d55e00", "#009e73", "#602060", "#00a0a0",
                                                "#802040", "#0000e0", "#604000", "#0060e0", "#000000"};
const char *const curve_color_of_submission = "#e02040";
