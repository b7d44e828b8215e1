// What the window shows, as plain data, and what its keys do to it. No GL, no window, no processes.
#pragma once

#include "window/compose.h"
#include "window/orbit.h"
#include "protocol/protocol.h"
#include "compile/rubric.h"

#include <stdbool.h>

enum { STATE_MAX_PIXEL = 16 };

typedef struct State {
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
    bool help, text, loupe; // shown
} State;

// The lab as it is graded for the whole picture, when it has a rubric with such a check; else the first
// scene. Knobs have their defaults, the seed is 1, time stands still.
void state_begin(State *state, const Rubric *rubric);

// What is to be drawn. False with a message when there is no such scene.
bool state_request(const State *state, int width, int height, Request *request);

// Do two requests of state_request ask for the same?
bool state_same(const Request *a, const Request *b);

// Does this state need the picture of mine, of the reference, of the truth?
bool state_needs_mine(const State *state);
bool state_needs_reference(const State *state);
bool state_needs_truth(const State *state);

// The value of the table's knob: what was set, or its default.
float state_knob(const State *state, const struct KnobText *knob);
void state_set_knob(State *state, const char *name, float value);

// Steps the selected knob (see knob_step.h); selects the next one; gives it, or all of them, the defaults.
void state_step_knob(State *state, const Description *table, int direction, bool fine);
void state_select_knob(State *state, const Description *table, int direction);
void state_reset_knob(State *state, const Description *table, bool all);

// The next or last entry of a circle: the rubric's checks with scene, knobs and view; the scenes of the
// rubric, or all; picture, visibility and the table's stages.
void state_step_check(State *state, const Rubric *rubric, int direction);
void state_step_scene(State *state, const Rubric *rubric, int direction);
void state_step_view(State *state, const Description *table, int direction);

// Keeps camera and light within what orbit_limit allows in this scene.
void state_limit(State *state);

// Camera, light and time as the scene has them.
void state_reset_orbits(State *state);

// "picture of fence spot, seed 1", for the text in the window.
void state_text(const State *state, const Rubric *rubric, char *text, size_t size);
