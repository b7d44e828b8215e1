#include "protocol/description.h"

#include "scene/check.h"

#include <math.h>
#include <string.h>

void description_clean_text(char *text, size_t size) {
    text[size - 1] = '\0';
    for (; *text; text++)
        if (*text < ' ' || *text > '~')
            *text = '?';
}

static void clean_names(char (*names)[LAB_MAX_NAME], int32_t *count, int most) {
    *count = *count < 0 ? 0 : *count > most ? most : *count;
    for (int i = 0; i < *count; i++)
        description_clean_text(names[i], LAB_MAX_NAME);
}

static void clean_knob(struct KnobText *knob) {
    description_clean_text(knob->name, sizeof knob->name);
    description_clean_text(knob->unit, sizeof knob->unit);
    clean_names(knob->choices, &knob->choice_count, LAB_MAX_CHOICES);
    if (!isfinite(knob->low) || !isfinite(knob->high) || !(knob->low <= knob->high))
        knob->low = knob->high = 0;
    knob->value = isfinite(knob->value) ? fminf(fmaxf(knob->value, knob->low), knob->high) : knob->low;
}

void description_clean(Description *description) {
    int32_t *knobs = &description->knob_count;
    description_clean_text(description->title, sizeof description->title);
    clean_names(description->passes, &description->pass_count, LAB_MAX_PASSES);
    clean_names(description->stages, &description->stage_count, LAB_MAX_STAGES);
    for (int i = 0; i < LAB_MAX_PASSES; i++)
        if (description->pass_kinds[i] < PASS_PICTURE || description->pass_kinds[i] > PASS_SHOW)
            description->pass_kinds[i] = PASS_PICTURE;
    *knobs = *knobs < 0 ? 0 : *knobs > LAB_MAX_KNOBS ? LAB_MAX_KNOBS : *knobs;
    for (int i = 0; i < *knobs; i++)
        clean_knob(&description->knobs[i]);
}

static bool fits_knob(const Description *lab, const KnobSetting *setting) {
    char known[LAB_MAX_KNOBS * (LAB_MAX_NAME + 4)] = "";
    for (int i = 0; i < lab->knob_count; i++) {
        const struct KnobText *knob = &lab->knobs[i];
        const bool fits = setting->value >= knob->low && setting->value <= knob->high,
                   whole = knob->choice_count == 0 || setting->value == floorf(setting->value);
        if (strcmp(knob->name, setting->name) == 0)
            return (fits && whole) ||
                   check_fail("the knob \"%s\" takes %s from %g to %g, not %g", knob->name,
                              knob->choice_count > 0 ? "a whole number" : "a number", (double)knob->low,
                              (double)knob->high, (double)setting->value);
        check_append(known, sizeof known, "%s\"%s\"", i ? ", " : "", knob->name);
    }
    return check_fail("the lab has no knob \"%s\"; its knobs are %s", setting->name,
                      lab->knob_count > 0 ? known : "none");
}

bool description_fits(const Description *description, const Request *request) {
    for (int i = 0; i < request->knob_count; i++)
        if (!fits_knob(description, &request->knobs[i]))
            return false;
    return true;
}

static double clean_count(double number) {
    return number >= 0 && number < 1e15 ? floor(number) : 0;
}

void description_clean_counts(FrameCounts *counts) {
    counts->taps = clean_count(counts->taps);
    counts->fragments = clean_count(counts->fragments);
    counts->texels = clean_count(counts->texels);
    description_clean_text(counts->uncounted, sizeof counts->uncounted);
}
