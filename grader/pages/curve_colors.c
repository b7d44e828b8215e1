#include "pages/curve_colors.h"

const char *const curve_colors[CURVE_COLORS] = {"#0072b2", "#d55e00", "#009e73", "#b45a8c", "#b87d00",
                                                "#2c8fc9", "#000000", "#7f7f00", "#6a3d9a", "#8c564b"};
const char *const curve_color_of_submission = "#d00000";
