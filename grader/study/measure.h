// Measures all settings of a scene: each one's error once, its times frame by frame in turn with the others.
//
// Interface: fill in a StudyPlan (size, frames, folder, who draws, what is known already); measure_scene
// fills the findings of one scene (finding.h), which the charts and tables read.
#pragma once

#include "study/lab_artists.h"
#include "study/finding.h"
#include "base/progress_bar.h"

typedef struct StudyPlan {
    MetricsSize size;
    int frames;         // of each setting
    const char *output; // folder; pictures go to output/frames/KEY.png
    LabArtists artists;
    char renderer[128]; // that draws, as Reply has it; known once a scene was measured
    Measurements state;
    ProgressBar bar;
} StudyPlan;

// Fills the findings of this scene with its settings, and those of the submission behind them;
// measures what the state does not hold. False with a message when something of ours fails; a submission that
// does not draw is a finding.
bool measure_scene(StudyPlan *plan, const StudyScene *scene, SceneFindings *findings);

// Does the scene have settings of this lab?
bool measure_concerns(const StudyScene *scene, const char *lab);
