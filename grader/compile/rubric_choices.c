#include "compile/rubric_choices.h"

#include "scene/check.h"
#include "scene/scene.h"

#include <stdio.h>
#include <string.h>

static const JsonField scene_name_field = {"scene", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_NAME};
static const JsonField scene_list = {"scene", FIELD_LIST, FIELD_NEEDED, 1, RUBRIC_MAX_CHOICES};
static const JsonField knob_value = {"", FIELD_NUMBER, FIELD_NEEDED, -1e9, 1e9};
static const JsonField knob_list = {"", FIELD_LIST, FIELD_NEEDED, 1, RUBRIC_MAX_CHOICES};
static const JsonField range_fields[] = {
    {"from", FIELD_NUMBER, FIELD_NEEDED, -1e9, 1e9}, {"to", FIELD_NUMBER, FIELD_NEEDED, -1e9, 1e9}, {0}};

static bool check_scene(const JsonPlace *place, const char *name) {
    static Scene scene; // of some kilobytes
    char text[1200];
    check_clear();
    if (scene_make(&scene, name, &(Random){1}))
        return true;
    snprintf(text, sizeof text, "%s", check_message());
    check_clear();
    return json_fields_fail(place, "scene", "%s", text);
}

bool rubric_choices_scenes(Check *check, const JsonPlace *place, const json_t *scenes) {
    const size_t count = json_is_array(scenes) ? json_array_size(scenes) : 1;
    if (json_is_array(scenes) && !json_fields_fits(place, scenes, &scene_list))
        return false;
    for (size_t i = 0; i < count; i++) {
        const json_t *scene = json_is_array(scenes) ? json_array_get(scenes, i) : scenes;
        if (!json_fields_fits(place, scene, &scene_name_field) ||
            !check_scene(place, json_string_value(scene)))
            return false;
        check->scenes[check->scene_count++] = json_string_value(scene);
    }
    check->scene = check->scenes[0];
    return true;
}

static bool read_list(KnobChoice *knob, const JsonPlace *place, json_t *values) {
    JsonField list = knob_list, entry = knob_value;
    size_t i;
    json_t *value;
    list.key = entry.key = knob->name;
    if (!json_fields_fits(place, values, &list))
        return false;
    json_array_foreach(values, i, value) {
        if (!json_fields_fits(place, value, &entry))
            return false;
        knob->choices[knob->choice_count++] = (float)json_number_value(value);
    }
    knob->value = knob->choices[0];
    return true;
}

static bool read_range(KnobChoice *knob, const JsonPlace *place, const json_t *range) {
    const json_t *from = json_object_get(range, "from"), *to = json_object_get(range, "to");
    if (!json_fields_check(place, range, range_fields))
        return false;
    knob->value = knob->low = (float)json_number_value(from);
    knob->high = (float)json_number_value(to);
    knob->whole = json_is_integer(from) && json_is_integer(to);
    return knob->low < knob->high ||
           json_fields_fail(place, knob->name, "\"to\" is not above \"from\"; write a larger number");
}

static bool read_knob(KnobChoice *knob, const JsonPlace *place, json_t *value) {
    JsonField field = knob_value;
    field.key = knob->name;
    if (json_is_array(value))
        return read_list(knob, place, value);
    if (json_is_object(value))
        return read_range(knob, place, value);
    if (!json_fields_fits(place, value, &field))
        return false;
    knob->value = knob->choices[knob->choice_count++] = (float)json_number_value(value);
    return true;
}

bool rubric_choices_knobs(Check *check, const JsonPlace *place, json_t *knobs) {
    const char *name;
    json_t *value;
    json_object_foreach(knobs, name, value) {
        if (strlen(name) >= LAB_MAX_NAME)
            return json_fields_fail(place, "knobs",
                                    "a name is longer than %d bytes; write one of lab.c's table",
                                    LAB_MAX_NAME - 1);
        KnobChoice *knob = &check->knobs[check->knob_count++];
        *knob = (KnobChoice){.name = name};
        if (!read_knob(knob, place, value))
            return false;
    }
    return true;
}
