// The scenes of the study: each holds no more than it needs to show one phenomenon. A lab brings its own in
// its study.c.
#pragma once

#include "study/method.h"

#include <stdbool.h>

// Interior errors that count as none: of hard light one pixel in ten thousand, for at the creases of a mesh
// a slope says little; of soft light what counts as equal in grading.
#define STUDY_HARD 1e-4
#define STUDY_SOFT (2 / 255.0)

// In the scene "penumbra" a disc with the radius of the map's side divided by this is the area light's, as
// the map sees it: the kernel that a filter must have there.
enum { STUDY_KERNEL = 64, STUDY_SIZES = 5 };

enum { STUDY_WIDTH = 640, STUDY_HEIGHT = 480 }; // of the pictures that the limits are for

extern const int study_sizes[STUDY_SIZES]; // of shadow maps, texels along a side

typedef struct StudyScene {
    const char *name;  // of files
    const char *title; // of the chart
    const char *shows; // one sentence
    void (*make)(Scene *scene);
    TruthQuery query;
    bool edges;       // the true shadow has edges; else all of it is interior
    double tolerance; // interior error that counts as none: the mean over the picture, 0..1
    bool moves;       // what changes from frame to frame is measured, too (motion.h)
} StudyScene;

// What a lab's methods compete in (compete/README.md).
typedef struct StudyContest {
    const char *lab, *scene;
    double most_error; // 0..1: who errs more takes no part
} StudyContest;

// What a lab brings to the study: a solutions/NN-name/study.c defines one as LAB_TABLE.
typedef struct LabStudy {
    const StudyScene *scenes; // its own; ends with one without a name; NULL: it has none
    // Adds the lab's settings in the scene of this name, which may be another lab's.
    void (*add_methods)(MethodList *list, const char *scene);
    // Makes fit again what must fit camera and lights in a scene of this name, after they were moved
    // (views.h); NULL: nothing must.
    void (*settle)(Scene *scene, const char *name);
    StudyContest contest; // zeroed: it has none
} LabStudy;

extern const LabStudy *const study_tables[]; // of all labs, in their order, then NULL: made by build.mk

// Scene number i, in the order of the labs; NULL after the last.
const StudyScene *study_scene(int i);

// The scene of this name; NULL: there is none.
const StudyScene *study_scene_named(const char *name);

// The contest of lab "14"; NULL with a message when it has none.
const StudyContest *study_contest(const char *lab);

// How many objects it has.
int study_count_objects(const StudyScene *scene);

// Makes the list that of all labs' settings in this scene.
void study_add_methods(MethodList *list, const StudyScene *scene);

// What the labs settle in a scene whose camera and lights were moved.
void study_settle(Scene *scene, const StudyScene *of);

// For makers of scenes. An object turned in the plane of the picture of a camera at +z, by `turn` degrees
// about +z.
void study_add_turned(Scene *scene, Shape shape, vec3s center, vec3s half_size, float turn);

// The camera, 40 degrees high.
void study_look(Scene *scene, vec3s eye, vec3s target);
