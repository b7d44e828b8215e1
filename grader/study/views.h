// The cameras and lights from which a scene is studied: what a scene needs must not hang on one of them.
#pragma once

#include "base/files.h"
#include "study/measurements.h"
#include "study/motion.h"
#include "study/study_scene.h"
#include "truth/flip.h"

enum {
    STUDY_VIEWS = 6,
    STUDY_ACROSS = 8 // rays of a pixel along a side, and that twice
};

typedef struct StudyView {
    TruthView truth_view; // its truth is that of whole pixels
    FlipPicture flip;     // of that truth
    Motion motion;        // where the scene moves
} StudyView;

// Makes the scene as view `view` (0..STUDY_VIEWS - 1) has it. View 0 is the scene itself; in the others the
// camera goes up to 12 degrees around its target, 15 % higher or lower and 10 % nearer or farther, and the
// light up to 8 degrees around its own.
void views_make(const StudyScene *scene, int view, Scene *made);

// The same with moves within these ranges that are drawn at random.
void views_make_drawn(const StudyScene *scene, Random *random, Scene *made);

// Traces the view's truth, or takes it from `folder` where it was left by the same view of the same scene;
// `artist` draws the triangles. False with a message.
bool view_create(StudyView *view, const StudyScene *scene, int number, MetricsSize size, const char *folder,
                 LabArtist *artist);
// The same of a scene that views_make or views_make_drawn has made.
bool view_create_of(StudyView *view, const StudyScene *scene, const Scene *made, MetricsSize size,
                    const char *folder, LabArtist *artist);
void view_destroy(StudyView *view); // accepts a zeroed view

// How far a frame (its visibility is there; mask and metrics are filled) is from the view's truth. False with
// a message when there is no memory.
bool view_compare(const StudyView *view, const StudyScene *scene, const Setting *setting, Measured *frame,
                  MeasuredErrors *errors);
