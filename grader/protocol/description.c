#include "protocol/description.h"

#include <math.h>

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
