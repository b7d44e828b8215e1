// What every method of a scene is held against beside the truth: frames that take no method.
#pragma once

#include "study/views.h"

enum { BASELINES_MOST = 8, BASELINE_NAME = 40 };

typedef struct Baseline {
    char name[BASELINE_NAME];
    MeasuredErrors errors;          // means over the views
    double worst_inside, worst_off; // interior error and edge of the view in which they are largest
    bool is_floor;                  // the truth's own noise: below it a chart says nothing
} Baseline;

typedef struct Baselines {
    Baseline lines[BASELINES_MOST];
    int count;
} Baselines;

// Adds this view's share of the lines of a scene that has `views` of them: no shadow, all shadow, the truth's
// noise, for hard light the truth at the pixels' centres, and for an endless sky shorter rays. False with a
// message.
bool baselines_add(Baselines *lines, const StudyScene *scene, const StudyView *view, int views);

// The truth's noise; NULL before baselines_add.
const Baseline *baselines_floor(const Baselines *lines);
