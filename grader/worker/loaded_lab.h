// The labs that a worker has loaded, and how one draws a frame.
#pragma once

#include "protocol/protocol.h"
#include "worker/stage_view.h"

#include <stdbool.h>

typedef struct HostedLab {
    char folder[PROTOCOL_PATH]; // holds lab.so and the lab's shaders
    const Lab *lab;
    Program programs[LAB_MAX_PROGRAMS];
    int program_count;
    Target picture, readback;
    float knobs[LAB_MAX_KNOBS];
    bool ready;                  // the lab and its programs are there
    bool created;                // lab->create was called
    char failure[PROTOCOL_TEXT]; // why it is not ready
} HostedLab;

// The lab in `folder`, loaded when it is first asked for; NULL when there is no room for more labs. A lab
// that cannot be loaded is not ready and draws nothing.
HostedLab *host_find(const char *folder, const char *shader_folder);

// Draws the frame and writes its pixels; false with a message when the lab failed.
bool host_draw(HostedLab *hosted, const StageView *view, const Request *request, float *milliseconds,
               uint8_t *pixels);

// Writes the lab's table; false with a message when there is none.
bool host_describe(const HostedLab *hosted, Description *description);

// The pass (or "create") that runs just now, for a report of a crash; NULL between frames.
const char *host_running(void);

// Lets every lab free what it holds.
void host_destroy(void);
