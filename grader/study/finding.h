// What the study found out about one setting, and about all settings of a scene.
#pragma once

#include "study/pareto.h"
#include "study/study_scene.h"
#include "study/measurements.h"

typedef struct Finding {
    Method method;
    uint64_t key; // of its measurements and of its frame's picture
    bool drawn;   // false: a submission that did not draw; `message` says why
    char message[200];
    MeasuredErrors errors;
    int frames;
    double prepare_ms, prepare_mad, shade_ms,
        shade_mad; // before the picture (map, volumes, bake), and the picture
    Cost cost;
    bool enough; // no interior error, and an edge that is off by at most FINDING_MOST_OFF
    bool chosen; // the cheapest of ours that is enough
} Finding;

#define FINDING_MOST_OFF 0.5 // pixels

typedef struct SceneFindings {
    const StudyScene *scene;
    Finding findings[METHOD_MOST];
    Point points[METHOD_MOST]; // of the findings; a negative time where nothing was drawn
    int count;
    const char *renderer; // that drew them all, as Reply has it
    bool on_gpu;          // the times are the GPU's, not the processor's
} SceneFindings;

// Sum of false shadow and false light, in the interior and in all of the picture.
double finding_interior_error(const MeasuredErrors *errors);
double finding_error(const MeasuredErrors *errors);

// From errors and times to front, enough and chosen. `times` are scratch.
void findings_judge(SceneFindings *findings);

// The finding that is chosen; NULL when none is enough.
const Finding *findings_chosen(const SceneFindings *findings);

// The most expensive one of the front that is cheaper than the chosen one; NULL when there is none.
const Finding *findings_next_cheaper(const SceneFindings *findings);

// One line: what this scene needs, and what the next cheaper setting gets wrong.
void findings_tell(const SceneFindings *findings, char *text, size_t size);

// Median and MAD of all frames' times.
void finding_time(Finding *finding, Point *point, const MeasuredTime *times, int count);
