// The labs that a worker has loaded, and how one draws a frame.
#pragma once

#include "protocol/protocol.h"
#include "worker/stage_view.h"

#include <stdbool.h>

typedef struct LoadedLab {
    char folder[PROTOCOL_PATH]; // holds lab.so and the lab's shaders
    const Lab *lab;
    Program programs[LAB_MAX_PROGRAMS];
    int program_count;
    Target picture, readback;
    float knobs[LAB_MAX_KNOBS];
    bool ready;                  // the lab and its programs are there
    bool created;                // lab->create was called
    char failure[PROTOCOL_TEXT]; // why it is not ready
} LoadedLab;

// The lab in `folder`, loaded when it is first asked for; NULL when there is no room for more labs. A lab
// that cannot be loaded is not ready and draws nothing.
LoadedLab *loaded_lab_find(const char *folder, const char *shader_folder);

// Draws the frame, writes its pixels and, of the reply, times and facts; false with a message when the lab
// failed.
bool loaded_lab_draw(LoadedLab *hosted, const StageView *view, const Request *request, Reply *reply,
                     uint8_t *pixels);

// Writes the lab's table; false with a message when there is none.
bool loaded_lab_describe(const LoadedLab *hosted, Description *description);

// The pass (or "create") that runs just now, for a report of a crash; "the lab" between frames. LAB_MAX_NAME
// bytes.
const char *loaded_lab_running(void);

// Lets every lab free what it holds.
void loaded_lab_destroy(void);
