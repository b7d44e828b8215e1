// The command line of build/chart.
#pragma once

#include "study/measure.h"

#include <stdbool.h>

enum { CHART_OPTIONS_SCENES = 16 };

typedef struct ChartOptions {
    const char *scenes[CHART_OPTIONS_SCENES], *lab, *submission, *output;
    int scene_count, frames;
    MetricsSize size;
    bool quick, compare;
    bool trusted; // no jail for the submission
} ChartOptions;

extern const char chart_options_usage[];

// Fills `options`, which is zeroed. False with a message. What is no option begins at getopt's optind.
bool chart_options_parse(ChartOptions *options, int count, char **arguments);

// Is this scene to be measured?
bool chart_options_want(const ChartOptions *options, const StudyScene *scene);
