// The scenes of the study: each holds no more than it needs to show one phenomenon.
#pragma once

#include "study/method.h"

#include <stdbool.h>

// In the scene "penumbra" a disc with the radius of the map's side divided by this is the area light's, as
// the map sees it.
enum { SCENES_KERNEL = 64 };

typedef struct StudyScene {
    const char *name;  // of files
    const char *title; // of the chart
    const char *shows; // one sentence
    void (*make)(Scene *scene);
    TruthQuery query;
    void (*add_methods)(MethodList *list);
    bool edges;       // the true shadow has edges; else all of it is interior
    double tolerance; // interior error that counts as none: the mean over the picture, 0..1
} StudyScene;

extern const StudyScene study_scenes[]; // ends with one without a name
