// The command line of build/chart.
#pragma once

#include "measure.h"

#include <stdbool.h>

enum { OPTIONS_SCENES = 16 };

typedef struct Options {
    const char *scenes[OPTIONS_SCENES], *lab, *submission, *output;
    int scene_count, frames;
    MetricsSize size;
    bool quick, compare;
} Options;

extern const char options_usage[];

// Fills `options`, which is zeroed. False with a message. What is no option begins at getopt's optind.
bool options_parse(Options *options, int count, char **arguments);

// Is this scene to be measured?
bool options_want(const Options *options, const StudyScene *scene);
