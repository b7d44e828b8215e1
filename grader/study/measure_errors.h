// The errors of a setting in all views of a scene.
#pragma once

#include "study/finding.h"
#include "study/study_plan.h"

// Fills the finding's keys, errors and views by frames of its method, or by what the state holds; keeps the
// frame of the first view as a picture. False with a message.
bool measure_errors(StudyPlan *plan, const StudyView views[STUDY_VIEWS], const StudyScene *scene,
                    Finding *finding);
