// How a study is carried out, and what is known already.
#pragma once

#include "base/progress_bar.h"
#include "study/lab_artists.h"
#include "study/measurements.h"

typedef struct StudyPlan {
    MetricsSize size;
    int frames;         // of each setting
    const char *output; // folder; pictures go to output/frames/KEY.png
    LabArtists artists;
    char renderer[128]; // that draws, as Reply has it; known once a scene was measured
    Measurements state;
    ProgressBar bar;
} StudyPlan;
