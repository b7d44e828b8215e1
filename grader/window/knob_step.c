#include "window/knob_step.h"

#include "scene/check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SMALL_RANGE = 32, STEPS = 20, WIDE = 100, FINE = 10 };

static bool is_whole(const struct KnobText *knob) {
    return knob->low == floorf(knob->low) && knob->high == floorf(knob->high) &&
           knob->value == floorf(knob->value);
}

// The next power of two, or 0 below 1.
static float step_power(float value, int direction) {
    if (direction > 0)
        return value < 1 ? 1 : exp2f(floorf(log2f(value)) + 1);
    return value <= 1 ? 0 : exp2f(ceilf(log2f(value)) - 1);
}

static float step_whole(const struct KnobText *knob, float value, int direction, bool fine) {
    if (fine || knob->high - knob->low <= SMALL_RANGE)
        return roundf(value) + (float)direction;
    return step_power(value, direction);
}

static float step_real(const struct KnobText *knob, float value, int direction, bool fine) {
    float share = fine ? 1.0F / FINE : 1;
    if (knob->low > 0 && knob->high / knob->low >= WIDE)
        return value * exp2f((float)direction * 0.5F * share);
    float step = (knob->high - knob->low) / STEPS * share;
    return step > 0 ? step * roundf((value + (float)direction * step) / step) : value;
}

float knob_step(const struct KnobText *knob, float value, int direction, bool fine) {
    float next =
        is_whole(knob) ? step_whole(knob, value, direction, fine) : step_real(knob, value, direction, fine);
    return fminf(fmaxf(next, knob->low), knob->high);
}

const char *knob_choice(const struct KnobText *knob, float value) {
    long number = lrintf(value);
    return number >= 0 && number < knob->choice_count ? knob->choices[number] : "";
}

// Large numbers without an exponent.
static void add_number(char *text, size_t size, float value) {
    check_append(text, size, fabsf(value) < 1000 ? "%.4g" : "%.0f", (double)value);
}

void knob_text(const struct KnobText *knob, float value, char *text, size_t size) {
    const char *choice = knob_choice(knob, value);
    text[0] = '\0';
    if (!choice[0]) {
        add_number(text, size, value);
        check_append(text, size, "%s%s  (", knob->unit[0] ? " " : "", knob->unit);
        add_number(text, size, knob->low);
        check_append(text, size, "..");
        add_number(text, size, knob->high);
        check_append(text, size, ")");
        return;
    }
    check_append(text, size, "%g: %s", (double)value, choice);
    for (int i = 0; i < knob->choice_count; i++)
        check_append(text, size, "%s%s", i ? ", " : "  (", knob->choices[i]);
    check_append(text, size, ")");
}
