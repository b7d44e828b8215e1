// What the window shows, as plain data, and what its keys do to it. No GL, no window, no processes.
#pragma once

#include "window/compose.h"
#include "window/orbit.h"
#include "protocol/protocol.h"
#include "compile/rubric.h"

#include <stdbool.h>

enum { STATE_MAX_PIXEL = 16 };

typedef enum LightShown { LIGHT_HIDDEN, LIGHT_FRUSTUM, LIGHT_TEXELS, LIGHT_SHOWN_COUNT } LightShown;

typedef struct ViewState {
    Show show;
    bool against_truth; // SPLIT and DIFFERENCE: the truth, not the reference, is the other one
    float split;        // 0..1
    int check;          // of the rubric; -1: none
    char scene[LAB_MAX_NAME], view[LAB_MAX_NAME]; // a view of protocol.h or a stage
    uint64_t seed;
    KnobSetting knobs[LAB_MAX_KNOBS]; // those that were set, by name
    int knob_count;
    int selected; // knob of the table
    Orbit camera, light;
    double time; // seconds that the light has swung
    bool running;
    int pixel;              // side of a pixel of the picture in those of the window
    bool text, loupe;       // shown
    int help;               // page of the keys that is shown, from 1; 0: none
    bool volumes;           // shown: the casters' shadow volumes, as haze
    LightShown light_shown; // of the lights' maps
} ViewState;

// The lab as it is graded for the whole picture, when it has a rubric with such a check; else the first
// scene. Knobs have their defaults, the seed is 1, time stands still.
void view_state_begin(ViewState *state, const Rubric *rubric);

// What is to be drawn. False with a message when there is no such scene.
bool view_state_request(const ViewState *state, int width, int height, Request *request);

// Do two requests of view_state_request ask for the same?
bool view_state_same(const Request *a, const Request *b);

// Does this state need the picture of mine, of the reference, of the truth?
bool view_state_needs_mine(const ViewState *state);
bool view_state_needs_reference(const ViewState *state);
bool view_state_needs_truth(const ViewState *state);

// The value of the table's knob: what was set, or its default.
float view_state_knob(const ViewState *state, const struct KnobText *knob);
void view_state_set_knob(ViewState *state, const char *name, float value);

// Steps the selected knob (see knob_step.h); selects the next one; gives it, or all of them, the defaults.
void view_state_step_knob(ViewState *state, const Description *table, int direction, bool fine);
void view_state_select_knob(ViewState *state, const Description *table, int direction);
void view_state_reset_knob(ViewState *state, const Description *table, bool all);

// The next or last entry of a circle: the rubric's checks with scene, knobs and view; the scenes of the
// rubric, or all; picture, visibility and the table's stages.
void view_state_step_check(ViewState *state, const Rubric *rubric, int direction);
void view_state_step_scene(ViewState *state, const Rubric *rubric, int direction);
void view_state_step_view(ViewState *state, const Description *table, int direction);

// Keeps camera and light within what orbit_limit allows in this scene.
void view_state_limit(ViewState *state);

// Camera, light and time as the scene has them.
void view_state_reset_orbits(ViewState *state);

// "picture of fence spot, seed 1", for the text in the window.
void view_state_text(const ViewState *state, const Rubric *rubric, char *text, size_t size);
