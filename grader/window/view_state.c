// Steps of keys through checks, scenes, views and knobs, and the request that the state stands for.
#include "window/view_state.h"

#include "scene/check.h"
#include "window/knob_step.h"

#include <stdio.h>
#include <string.h>

enum { MAX_SCENES = 64 };

static void set_name(char name[LAB_MAX_NAME], const char *text) {
    snprintf(name, LAB_MAX_NAME, "%s", text);
}

static int list_once(const char *scenes[MAX_SCENES], int count, const char *scene) {
    for (int i = 0; i < count; i++)
        if (strcmp(scenes[i], scene) == 0)
            return count;
    if (count < MAX_SCENES)
        scenes[count++] = scene;
    return count;
}

// Names of the scenes to go through, each once.
static int list_scenes(const Rubric *rubric, const char *scenes[MAX_SCENES]) {
    int count = 0;
    for (int c = 0; c < rubric->check_count; c++)
        for (int n = 0; n < rubric->checks[c].scene_count; n++)
            count = list_once(scenes, count, rubric->checks[c].scenes[n]);
    for (int i = 0; rubric->check_count == 0 && count < MAX_SCENES && scene_name(i); i++)
        scenes[count++] = scene_name(i);
    return count;
}

void view_state_begin(ViewState *state, const Rubric *rubric) {
    const char *scenes[MAX_SCENES];
    *state = (ViewState){.split = 0.5F, .check = -1, .seed = 1, .pixel = 1, .text = true};
    set_name(state->view, VIEW_PICTURE);
    set_name(state->scene, list_scenes(rubric, scenes) > 0 ? scenes[0] : "");
    for (int c = 0; c < rubric->check_count; c++)
        if (strcmp(rubric->checks[c].view, VIEW_PICTURE) == 0)
            set_name(state->scene, rubric->checks[c].scene);
}

bool view_state_needs_truth(const ViewState *state) {
    bool compares = state->show == SHOW_SPLIT || state->show == SHOW_DIFFERENCE;
    return state->show == SHOW_TRUTH || (compares && state->against_truth);
}

bool view_state_needs_reference(const ViewState *state) {
    bool compares = state->show == SHOW_SPLIT || state->show == SHOW_DIFFERENCE;
    return state->show == SHOW_REFERENCE || (compares && !state->against_truth);
}

bool view_state_needs_mine(const ViewState *state) {
    return state->show == SHOW_MINE || state->show == SHOW_SPLIT || state->show == SHOW_DIFFERENCE;
}

static void move(const ViewState *state, Scene *scene) {
    Orbit light = orbit_swing(&state->light, state->time);
    orbit_camera(&scene->camera, &state->camera);
    for (int i = 0; i < scene->light_count && i < SCENE_MAX_LIGHTS; i++)
        orbit_light(&scene->lights[i], &light);
}

bool view_state_request(const ViewState *state, int width, int height, Request *request) {
    memset(request, 0, sizeof *request);
    request->magic = PROTOCOL_MAGIC;
    request->own_shape = 1;
    request->width = width < PROTOCOL_MAX_SIZE ? width : PROTOCOL_MAX_SIZE;
    request->height = height < PROTOCOL_MAX_SIZE ? height : PROTOCOL_MAX_SIZE;
    set_name(request->view, view_state_needs_truth(state) ? VIEW_VISIBILITY : state->view);
    memcpy(request->knobs, state->knobs, sizeof request->knobs);
    request->knob_count = state->knob_count;
    if (!scene_make(&request->scene, state->scene, &(Random){state->seed}))
        return false;
    move(state, &request->scene);
    return true;
}

bool view_state_same(const Request *a, const Request *b) {
    const unsigned char *bytes = (const unsigned char *)a, *others = (const unsigned char *)b;
    return memcmp(bytes, others, sizeof *a) == 0; // both began as zeroes, padding included
}

static int find_knob(const ViewState *state, const char *name) {
    int i = 0;
    while (i < state->knob_count && strcmp(state->knobs[i].name, name) != 0)
        i++;
    return i;
}

float view_state_knob(const ViewState *state, const struct KnobText *knob) {
    int i = find_knob(state, knob->name);
    return i < state->knob_count ? state->knobs[i].value : knob->value;
}

void view_state_set_knob(ViewState *state, const char *name, float value) {
    int i = find_knob(state, name);
    if (i == LAB_MAX_KNOBS)
        return;
    if (i == state->knob_count)
        state->knob_count++;
    set_name(state->knobs[i].name, name);
    state->knobs[i].value = value;
}

void view_state_step_knob(ViewState *state, const Description *table, int direction, bool fine) {
    if (state->selected >= table->knob_count)
        return;
    const struct KnobText *knob = &table->knobs[state->selected];
    view_state_set_knob(state, knob->name, knob_step(knob, view_state_knob(state, knob), direction, fine));
}

// The neighbour of `at` on a circle of `count`.
static int around(int at, int count, int direction) {
    return (at + direction + count) % count;
}

void view_state_select_knob(ViewState *state, const Description *table, int direction) {
    if (table->knob_count > 0)
        state->selected = around(state->selected, table->knob_count, direction);
}

void view_state_reset_knob(ViewState *state, const Description *table, bool all) {
    for (int i = 0; i < table->knob_count; i++)
        if (all || i == state->selected)
            view_state_set_knob(state, table->knobs[i].name, table->knobs[i].value);
}

void view_state_step_check(ViewState *state, const Rubric *rubric, int direction) {
    if (rubric->check_count == 0)
        return;
    bool outside = state->check < 0;
    state->check = outside ? (direction > 0 ? 0 : rubric->check_count - 1)
                           : around(state->check, rubric->check_count, direction);
    const Check *check = &rubric->checks[state->check];
    set_name(state->scene, check->scene);
    set_name(state->view, check->view);
    state->knob_count = 0;
    for (int i = 0; i < check->knob_count; i++)
        view_state_set_knob(state, check->knobs[i].name, check->knobs[i].value);
}

void view_state_step_scene(ViewState *state, const Rubric *rubric, int direction) {
    const char *scenes[MAX_SCENES];
    int count = list_scenes(rubric, scenes), at = 0;
    if (count == 0)
        return;
    while (at < count && strcmp(scenes[at], state->scene) != 0)
        at++;
    set_name(state->scene, scenes[at == count ? 0 : around(at, count, direction)]);
}

void view_state_step_view(ViewState *state, const Description *table, int direction) {
    const char *views[LAB_MAX_STAGES + 2] = {VIEW_PICTURE, VIEW_VISIBILITY};
    int count = 2, at = 0;
    for (int i = 0; i < table->stage_count; i++)
        views[count++] = table->stages[i];
    while (at < count && strcmp(views[at], state->view) != 0)
        at++;
    set_name(state->view, views[at == count ? 0 : around(at, count, direction)]);
}

void view_state_limit(ViewState *state) {
    Scene scene;
    if (!scene_make(&scene, state->scene, &(Random){state->seed}))
        return;
    orbit_limit(&state->camera, glms_vec3_sub(scene.camera.eye, scene.camera.target));
    if (scene.light_count > 0)
        orbit_limit(&state->light, glms_vec3_sub(scene.lights[0].position, scene.lights[0].target));
}

void view_state_reset_orbits(ViewState *state) {
    state->camera = state->light = (Orbit){0};
    state->time = 0;
    state->running = false;
}

// Is everything as the check that was chosen last has it?
static bool matches(const ViewState *state, const Check *check) {
    bool same = strcmp(state->scene, check->scene) == 0 && strcmp(state->view, check->view) == 0 &&
                state->knob_count == check->knob_count;
    for (int i = 0; same && i < check->knob_count; i++)
        same = strcmp(state->knobs[i].name, check->knobs[i].name) == 0 &&
               state->knobs[i].value == check->knobs[i].value;
    return same;
}

void view_state_text(const ViewState *state, const Rubric *rubric, char *text, size_t size) {
    text[0] = '\0';
    check_append(text, size, "%s of \"%s\", seed %llu",
                 view_state_needs_truth(state) ? VIEW_VISIBILITY : state->view, state->scene,
                 (unsigned long long)state->seed);
    if (state->time != 0)
        check_append(text, size, ", light at %.1f s", state->time);
    if (state->check >= 0 && matches(state, &rubric->checks[state->check]))
        check_append(text, size, "  [check %s: %s]", rubric->checks[state->check].task,
                     rubric->checks[state->check].name);
}
