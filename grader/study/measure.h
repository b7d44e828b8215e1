// Measures all settings of a scene: each one's error once, its times frame by frame in turn with the others.
//
// Interface: fill in a StudyPlan (size, frames, folder, who draws, what is known already); measure_scene
// fills the findings of one scene (finding.h), which the charts and tables read.
#pragma once

#include "study/finding.h"
#include "study/study_plan.h"

// Fills the findings of this scene with its settings, and those of the submission behind them;
// measures what the state does not hold. False with a message when something of ours fails; a submission that
// does not draw is a finding.
bool measure_scene(StudyPlan *plan, const StudyScene *scene, SceneFindings *findings);

// Does the scene have settings of this lab?
bool measure_concerns(const StudyScene *scene, const char *lab);
