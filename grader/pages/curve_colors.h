// The colours of curves and points, in pictures and on pages. Told apart without red or green, too, and dark
// enough for white paper (tests/c/test_curve_colors.c holds both); who draws more than one also gives each a
// shape or a dash of its own.
#pragma once

enum { CURVE_COLORS = 10 };

extern const char *const curve_colors[CURVE_COLORS];

// What a student handed in, beside ours.
extern const char *const curve_color_of_submission;
