// Sets the state as a recorded frame has it, and notices when a key has changed it since.
#include "window/app.h"

#include "scene/check.h"

#include <string.h>

bool app_recorded_shows(const App *app) {
    return app->recorded.open && !app->feeds[FEED_REFERENCE].running &&
           view_state_needs_reference(&app->state);
}

static void take_frame(App *app) {
    const Recorded *recorded = &app->recorded;
    const Request *request = &recorded->frame.request;
    ViewState *state = &app->state;
    view_state_reset_orbits(state);
    state->check = recorded->check;
    state->seed = recorded->seeds[recorded->seed];
    snprintf(state->scene, sizeof state->scene, "%s", recorded->frame.scene);
    snprintf(state->view, sizeof state->view, "%s", request->view);
    state->knob_count = 0;
    for (int i = 0; i < request->knob_count; i++)
        view_state_set_knob(state, request->knobs[i].name, request->knobs[i].value);
    app->at_frame = *state;
    app->new_frame = true;
    const bool copied = image_copy(&app->pictures[FEED_REFERENCE], &recorded->frame.reference);
    INVARIANT(copied);
    app_notice(app, "recorded: check %s, %s (C: the next check, N: its next variant)",
               recorded->rubric->checks[recorded->check].task,
               recorded->rubric->checks[recorded->check].name);
}

static bool is_same(const Orbit *a, const Orbit *b) {
    return a->azimuth == b->azimuth && a->elevation == b->elevation && a->zoom == b->zoom &&
           a->right == b->right && a->up == b->up;
}

// Is the state still that of the open frame, whatever is shown of it?
static bool is_there(const App *app) {
    const ViewState *state = &app->state, *frame = &app->at_frame;
    bool same = app->recorded.open && strcmp(state->scene, frame->scene) == 0 &&
                strcmp(state->view, frame->view) == 0 && state->seed == frame->seed &&
                state->time == frame->time && !state->running && state->knob_count == frame->knob_count &&
                is_same(&state->camera, &frame->camera) && is_same(&state->light, &frame->light);
    for (int i = 0; same && i < frame->knob_count; i++)
        same = strcmp(state->knobs[i].name, frame->knobs[i].name) == 0 &&
               state->knobs[i].value == frame->knobs[i].value;
    return same;
}

bool app_recorded_enter(App *app) {
    const ViewState *state = &app->state;
    if (is_there(app))
        return true;
    if (!recorded_open(&app->recorded, state->check, state->view, state->scene, state->seed))
        return false;
    take_frame(app);
    return true;
}

void app_recorded_step(App *app, int checks, int variants) {
    Recorded *recorded = &app->recorded;
    if (checks ? recorded_step_check(recorded, checks) : recorded_step_variant(recorded, variants))
        take_frame(app);
    else
        app_notice(app, "%s", check_message());
}

void app_recorded_follow(App *app) {
    if (!app_recorded_shows(app) || is_there(app))
        return;
    app->state.show = SHOW_MINE;
    app->state.check = -1;
    app_notice(app, "the reference is recorded only as the grader asks: 2, 3, 4 go back to it");
}

static bool has_knob(const ViewState *state, const KnobSetting *knob) {
    for (int i = 0; i < state->knob_count; i++)
        if (strcmp(state->knobs[i].name, knob->name) == 0)
            return state->knobs[i].value == knob->value;
    return false;
}

bool app_recorded_fits(const App *app) {
    const AppOptions *options = app->options;
    const ViewState *state = &app->state;
    bool fits = (!options->scene || strcmp(options->scene, state->scene) == 0) &&
                (!options->request.view[0] || strcmp(options->request.view, state->view) == 0) &&
                (options->seed == 1 || options->seed == state->seed);
    for (int i = 0; i < options->request.knob_count; i++)
        fits = fits && has_knob(state, &options->request.knobs[i]);
    return fits ||
           check_fail("no reference is recorded for this scene, view, seed and knobs: leave some away, "
                      "or look at mine or the truth");
}
