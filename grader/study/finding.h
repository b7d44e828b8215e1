// What the study found out about one setting, and about all settings of a scene.
#pragma once

#include "study/baselines.h"
#include "study/measurements.h"
#include "study/pareto.h"
#include "study/study_scene.h"
#include "study/views.h"

typedef struct Finding {
    Method method;
    uint64_t
        keys[STUDY_VIEWS];  // of its measurements in each view; the first is that of its frame's picture, too
    int timed[STUDY_VIEWS]; // frames whose times are known
    bool drawn;             // false: a submission that did not draw; `message` says why
    char message[200];
    MeasuredErrors views[STUDY_VIEWS], errors; // in each view, and their mean
    int frames;
    double prepare_ms, prepare_mad, shade_ms,
        shade_mad; // before the picture (map, volumes, bake), and the picture
    Cost cost;
    double worst_inside, worst_off; // interior error and edge of the view in which they are largest
    int enough_views;               // in which it is enough
    bool enough; // in all views: no interior error, and an edge that is off by at most FINDING_MOST_OFF
    bool chosen; // the cheapest of the labs that is enough
} Finding;

#define FINDING_MOST_OFF 0.5 // pixels

typedef struct SceneFindings {
    const StudyScene *scene;
    MetricsSize size; // of the pictures
    Finding findings[METHOD_MOST];
    Point points[METHOD_MOST]; // of the findings; a negative time where nothing was drawn
    int count;
    Baselines lines;
    const char *renderer; // that drew them all, as Reply has it
    bool on_gpu;          // the times are the GPU's, not the processor's
} SceneFindings;

// Sum of false shadow and false light, in the interior and in all of the picture.
double finding_interior_error(const MeasuredErrors *errors);
double finding_error(const MeasuredErrors *errors);

// Sums the views up: mean and worst.
void finding_errors(Finding *finding);

// Median and MAD of all frames' times.
void finding_time(Finding *finding, Point *point, const MeasuredTime *times, int count);

// The smallest and the largest error of a finding in any view.
void finding_range(const Finding *finding, double *low, double *high);
