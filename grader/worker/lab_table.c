#include "worker/lab_table.h"

#include <stdio.h>

static void describe_knob(struct KnobText *text, const Knob *knob) {
    snprintf(text->name, sizeof text->name, "%s", knob->name);
    snprintf(text->unit, sizeof text->unit, "%s", knob->unit ? knob->unit : "");
    text->low = knob->low;
    text->high = knob->high;
    text->value = knob->value;
    for (int i = 0; i < LAB_MAX_CHOICES && knob->choices[i]; i++)
        snprintf(text->choices[text->choice_count++], LAB_MAX_NAME, "%s", knob->choices[i]);
}

void lab_table_describe(const Lab *lab, Description *description) {
    snprintf(description->title, sizeof description->title, "%s", lab->title ? lab->title : "");
    for (int i = 0; i < LAB_MAX_KNOBS && lab->knobs[i].name; i++)
        describe_knob(&description->knobs[description->knob_count++], &lab->knobs[i]);
    for (int i = 0; i < LAB_MAX_PASSES && lab->passes[i].name; i++) {
        description->pass_kinds[i] = (int32_t)lab->passes[i].kind;
        snprintf(description->passes[description->pass_count++], LAB_MAX_NAME, "%s", lab->passes[i].name);
    }
    for (int i = 0; i < LAB_MAX_STAGES && lab->stages[i].name; i++)
        snprintf(description->stages[description->stage_count++], LAB_MAX_NAME, "%s", lab->stages[i].name);
}
