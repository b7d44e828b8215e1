// Everything of ours that draws for one lab: the solution, the skeleton, the solution without one task, with
// one mistake. Each is built when it is first asked for; all of them draw in one worker process.
//
// Interface: fill in rubric and context; painters_get builds one of ours, painters_draw lets it draw a
// request, painters_fit holds the rubric against its lab, painters_destroy ends the worker.
#pragma once

#include "base/limits.h"
#include "exam/worker_client.h"
#include "compile/parts.h"

#include <stdbool.h>

typedef struct Painter {
    Solved solved;
    const Change *change; // NULL: none
    char folder[FILES_PATH];
} Painter;

// Our lab with the parts p and q (-1: none) as they were handed out, as a change of the solution.
typedef struct Reset {
    int p, q;
    Change change; // its texts are owned
} Reset;

typedef struct Painters {
    const Rubric *rubric;
    ContextKind context;
    bool measures; // the driver may do its best, as for a submission that is measured: no quick shaders,
                   // and by EGL the machine's GPU
    WorkerClient client; // the worker
    Painter *painters[EXAM_MAX_PAINTERS];
    int count;
    Reset *resets[EXAM_MAX_RESETS]; // made when first asked for; owned
    int reset_count;
    bool fits; // painters_fit has found so
} Painters;

// Starts the worker, unless it runs. False with a message.
bool painters_start(Painters *painters);

// The lab with these tasks solved and this change, ready to draw. NULL with a message when it cannot be
// built.
const Painter *painters_get(Painters *painters, Solved solved, const Change *change);

// The solution with the parts p and q (-1: none) as they were handed out. NULL with a message when it cannot
// be built.
const Painter *painters_reset(Painters *painters, const Parts *parts, int p, int q);

// Draws with one of ours. False with a message when the worker is lost: a fault of ours. A lab that says why
// it drew nothing counts as black.
bool painters_draw(Painters *painters, const Painter *painter, const Request *request, Image *image,
                   Reply *reply);

// Has the worker ended, though nobody has stopped it?
bool painters_lost(const Painters *painters);

// Does the rubric fit the lab and its sources (rubric_fit.h)? Asks the solution, once. False with a message.
bool painters_fit(Painters *painters);

void painters_destroy(Painters *painters); // accepts a zeroed painters
