// What a client and the worker say to each other, through two pipes on one machine: first, unasked, a Reply
// with the magic PROTOCOL_READY that the worker is ready (drawn: 1) or why not; no code of a lab's has run by
// then. Then for each Request
// one Reply, followed by exactly width * height * 4 bytes of RGBA pixels (top row first), also when the lab
// failed; or, when the request asks for it, by a Description.
//
// Interface: Request and Reply, of which each side writes and reads whole ones (base/pipe.h); the names of
// views; the bounds of what either side may send. A client trusts no byte of a Reply (description.h).
#pragma once

#include "lab.h"

#include <stdint.h>

enum {
    PROTOCOL_MAGIC = 0x32424c53,
    PROTOCOL_CRASHED =
        0x58424c53,        // the magic of a worker's last Reply, as it dies by a signal; nothing follows
    PROTOCOL_REQUESTS = 0, // the worker's descriptors
    PROTOCOL_REPLIES = 3,
    PROTOCOL_MAX_SIZE = 4096, // width and height
    PROTOCOL_TEXT = 5000,
    PROTOCOL_PATH = 1024,
    PROTOCOL_LINE = 128
};

// Views that are not a stage of the lab.
#define VIEW_PICTURE "picture"       // the frame as its viewer sees it
#define VIEW_VISIBILITY "visibility" // lit white, shadow black, whatever the colours
#define VIEW_PRIMITIVES "primitives" // drawn by the worker, not by the lab: see primitives_view.h
#define VIEW_OCCLUSION "occlusion"   // of truth_worker alone: the sky, as far as the knob "ray length" says

typedef struct KnobSetting {
    char name[LAB_MAX_NAME];
    float value;
} KnobSetting;

typedef struct Request {
    uint32_t magic;
    int32_t width, height;
    int32_t
        fresh; // 1: the lab makes its resources again, so that the frame does not depend on those before it
    int32_t gpu_times; // 1: the reply tells the GPU's times, too, by timer queries
    int32_t counted;   // COUNTED_...: what the frame costs is counted; the same in all requests to one worker
    int32_t own_shape; // 1: a stage keeps the shape of its texture, in the middle of the picture, for people
                       // to look at; 0: it fills the picture
    int32_t describe;  // 1: a Description instead of a frame; what follows but `folder` does not matter
    char folder[PROTOCOL_PATH]; // of the lab, for a worker that was not given one
    char view[LAB_MAX_NAME];    // a view above or the name of a stage
    KnobSetting knobs[LAB_MAX_KNOBS];
    int32_t knob_count; // knobs not named keep their defaults
    Scene scene;
} Request;

enum {
    COUNTED_NOT,
    COUNTED_READS,
    COUNTED_BLIND // all reads of textures give 1: what is drawn then does not come from a map
};

// What a frame costs on any machine, from create to the last pass.
typedef struct FrameCounts {
    int32_t counted;                // as it was asked for
    double taps, fragments, texels; // reads of textures; shaded fragments; texels that were cleared
    char uncounted[64];             // what was done past the counters; "" for nothing
} FrameCounts;

// What a frame tells beside its pixels.
typedef struct FrameFacts {
    int32_t refused;                   // 1: GL refused a call, see gl_refused
    int32_t stage_width, stage_height; // of the texture, where the view is a stage; 0: there is none
} FrameFacts;

typedef struct Reply {
    uint32_t magic;
    int32_t drawn; // 1: the pixels are the lab's; 0: they are black, and `message` says why
    uint64_t
        place; // where in lab.so the crash was, or the call of which `message` tells at its end; 0: unknown
    char pass[LAB_MAX_NAME];                // of a crash: what ran
    float milliseconds[LAB_MAX_PASSES];     // CPU time of each pass
    float gpu_milliseconds[LAB_MAX_PASSES]; // the same of the GPU, where the request asked for it
    FrameFacts facts;
    FrameCounts counts;          // where the request asked for them
    char message[PROTOCOL_TEXT]; // why it was not drawn, or the first GL error or check_fail of the frame
    char remarks[1000];          // of the frame, a line each, see remark.h
    char renderer[128];          // "GL_VERSION / GL_RENDERER (way to it)", as context_route tells it
} Reply;

// The lab's table, for clients that do not know the lab. What a submission's worker sends is untrusted:
// worker_client_describe returns it with texts of printable ASCII, counts within the arrays and finite,
// ordered ranges.
typedef struct Description {
    char title[PROTOCOL_LINE];
    struct KnobText {
        char name[LAB_MAX_NAME], unit[PROTOCOL_LINE];
        float low, high, value;                      // value: the default
        char choices[LAB_MAX_CHOICES][LAB_MAX_NAME]; // of the values 0, 1, ..., choice_count - 1
        int32_t choice_count;
    } knobs[LAB_MAX_KNOBS];
    char passes[LAB_MAX_PASSES][LAB_MAX_NAME], stages[LAB_MAX_STAGES][LAB_MAX_NAME];
    int32_t pass_kinds[LAB_MAX_PASSES]; // PassKind
    int32_t knob_count, pass_count, stage_count;
} Description;

// The magic of a worker's first Reply. It tells a worker of another build, whose records have other sizes, so
// that the two would wait for each other: a client reads these four bytes first.
#define PROTOCOL_READY                                                                                       \
    ((uint32_t)(PROTOCOL_MAGIC ^ (sizeof(Request) + 31 * sizeof(Reply) + 1021 * sizeof(Description))))
