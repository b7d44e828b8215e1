// The contract between a lab and whoever runs it. A lab is one constant table named `lab` and the
// functions it names; a program called worker loads it and asks for frames. A lab knows common/
// and shaders/, nothing else.
#pragma once

#include "scene/check.h"
#include "draw.h"
#include "gl.h"
#include "gl_state.h"
#include "scene/mathx.h"
#include "program.h"
#include "scene/scene.h"

#include <stdbool.h>

#ifndef LAB_WITHOUT_EARLIER // which is then included beside it
#include "earlier.h"
#endif

// UNUSED(frame, program); keeps the compiler quiet about what only a later task uses. Values
// and functions of any type.
#define UNUSED(...) lab_leave_unused(0, __VA_ARGS__)
static inline void lab_leave_unused(int first, ...) {
    (void)first;
}

enum {
    LAB_MAX_PASSES = 8,
    LAB_MAX_KNOBS = 12,
    LAB_MAX_STAGES = 8,
    LAB_MAX_PROGRAMS = 8,
    LAB_MAX_CHOICES = 12,
    LAB_MAX_NAME = 32
};

// A parameter that the window puts on keys, the grader sets and the study sweeps. One that chooses names its
// choices: value 0 is the first of them, and what lies between low and high has a name.
typedef struct Knob {
    const char *name, *unit;
    float low, high, value; // value: the default
    const char *choices[LAB_MAX_CHOICES + 1];
} Knob;

// What a pass is for. The study counts what prepares and what makes the picture apart; what only shows
// something, as a stage or a lens, is nobody's cost, and is drawn when a stage is looked at.
typedef enum PassKind { PASS_PICTURE, PASS_PREPARE, PASS_SHOW } PassKind;

// One step of a frame; passes run in the order of the table. A pass sets what it needs (framebuffer,
// viewport, state): nothing is reset between passes, only before the first one (see gl_reset).
typedef struct Pass {
    const char *name;
    void (*draw)(const Frame *frame);
    PassKind kind;
} Pass;

// An intermediate result to look at: a 2D texture that the lab owns, colour or depth. It
// is read after the passes.
typedef struct Stage {
    const char *name;
    const GLuint *texture;
} Stage;

// Lists end at their first entry without a name (programs: without a vertex shader).
typedef struct Lab {
    const char *title;
    ProgramFiles programs[LAB_MAX_PROGRAMS + 1]; // compiled before create; frame->programs has the same order
    Knob knobs[LAB_MAX_KNOBS + 1];
    Pass passes[LAB_MAX_PASSES + 1];
    Stage stages[LAB_MAX_STAGES + 1];
    // Makes what the passes need, for frames of this size and these knobs; called again, after destroy, when
    // one of them changes. False with check_fail's message when it cannot.
    bool (*create)(const Frame *frame);
    // Frees what create made, also when create stopped half-way.
    void (*destroy)(void);
} Lab;

extern const Lab lab;
