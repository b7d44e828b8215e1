#include "study/setting_json.h"

json_t *setting_json(const Setting *setting) {
    json_t *knobs = json_object();
    for (int i = 0; i < setting->knob_count; i++)
        json_object_set_new(knobs, setting->knobs[i].name, json_real((double)setting->knobs[i].value));
    return knobs;
}
