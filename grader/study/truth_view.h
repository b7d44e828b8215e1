// The truth of one view of a scene, traced once and held against every method that draws it.
#pragma once

#include "study/lab_artist.h"
#include "truth/metrics.h"
#include "truth/truth.h"

// Arrays have size.width * size.height entries, top row first, and belong to the ground.
typedef struct TruthView {
    MetricsSize size;
    Truth truth;          // its scene is the one that was given
    TruthPicture picture; // what the camera sees
    int32_t *traced, *drawn;
    float *facing;     // N.L; 1 for occlusion, which has no direction
    float *visibility; // the truth, 0..1
    float *distance;   // to the true boundary, pixels
    float *center;     // once refined: the truth at the pixels' centres
    float *noise;      // once refined: what a truth of half as many rays has more
} TruthView;

// Traces the scene for this query; `artist` draws the triangles (any lab's does). False with a message.
bool truth_view_create(TruthView *truth_view, const Scene *scene, MetricsSize size, const TruthQuery *query,
                       LabArtist *artist);
// From now on the truth is that of whole pixels (truth/pixels.h), by across x across rays from the camera,
// twice. False with a message.
bool truth_view_refine(TruthView *truth_view, const TruthQuery *query, int across);

// The same with a truth that was traced before; takes both arrays, allocated with malloc. False with a
// message.
bool truth_view_take(TruthView *truth_view, float *visibility, float *noise);

void truth_view_destroy(TruthView *truth_view); // accepts a zeroed ground

// How a method is asked for its frame.
typedef struct Setting {
    const char *view; // VIEW_VISIBILITY, or a stage of the lab
    KnobSetting knobs[LAB_MAX_KNOBS];
    int knob_count;   // the others keep their defaults
    float edge_width; // pixels (metrics_edge_width); 0: METRICS_LEAST_EDGE
    int object;       // only the pixels of this object count; TRUTH_NONE: all
} Setting;

// Adds a knob to the setting.
void setting_knob(Setting *setting, const char *name, float value);

// A request for any scene with the setting's knobs and view.
Request setting_request(const Setting *setting, const Scene *scene, MetricsSize size);

// A method's frame beside the truth.
typedef struct Measured {
    Metrics metrics;
    float *visibility; // size.width * size.height, owned; NAN where the lab drew no finite colour
    uint8_t *mask;     // owned: 1 where the pixel counts
    float milliseconds[LAB_MAX_PASSES];
} Measured;

// Draws the ground's scene by `artist` and compares it with the truth. Its resources are made again where
// `fresh`. False with a message. The caller destroys what it got, also after a failure.
bool truth_view_measure(const TruthView *truth_view, LabArtist *artist, const Setting *setting, bool fresh,
                        Measured *measured);

// Draws the request, of the view VIEW_VISIBILITY, into an array of its pixels: 0..1, NAN where the lab drew
// no finite colour. `milliseconds`: of LAB_MAX_PASSES passes; NULL: not. False with a message.
bool truth_view_draw(LabArtist *artist, const Request *request, float *visibility, float *milliseconds);

// Fills mask and metrics of a frame whose visibility is there. All three arrays belong to the caller.
void truth_view_compare(const TruthView *truth_view, const Setting *setting, Measured *measured);

// Memory for a frame. False with a message.
bool measured_create(Measured *measured, MetricsSize size);
void measured_destroy(Measured *measured); // accepts a zeroed one

// A request for the ground's scene with the setting's knobs and view.
Request truth_view_request(const TruthView *truth_view, const Setting *setting);
