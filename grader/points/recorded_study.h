// What was recorded of the study for one lab: its settings in some scenes, with their times and errors.
#pragma once

#include "base/files.h"
#include "base/json_fields.h"
#include "compile/rubric.h"
#include "protocol/protocol.h"
#include "scene/image.h"

#include <stdbool.h>

enum { STUDY_MOST_SCENES = 16, STUDY_MOST_POINTS = 80, STUDY_NAME = 64 };

// Strings belong to the study.
typedef struct RecordedPoint {
    const char *family, *name, *view;
    KnobSetting knobs[LAB_MAX_KNOBS];
    int knob_count;
    Edit edit; // of a shader, which fixes a choice; its file is NULL where there is none
    double error, milliseconds;
} RecordedPoint;

typedef struct RecordedScene {
    const char *name, *title;
    double yardstick; // milliseconds of the lab as it was handed out, where it was recorded
    RecordedPoint points[STUDY_MOST_POINTS];
    int point_count;
} RecordedScene;

typedef struct RecordedStudy {
    const char *folder; // the rubric's
    int width, height;  // of all pictures
    RecordedScene scenes[STUDY_MOST_SCENES];
    int scene_count;
    json_t *json; // where the strings live
} RecordedStudy;

enum { STUDY_FILE = STUDY_NAME + 8 };

// The name of a scene's files in a lab's folder of records (recorded_scene.h), and where study.json lies.
void recorded_study_name(char name[STUDY_FILE], const char *scene);
void recorded_study_index(char path[FILES_PATH], const char *folder);

// Adds knobs from an object of names and values. False: these are no knobs, or too many.
bool recorded_study_knobs(KnobSetting knobs[LAB_MAX_KNOBS], int *count, json_t *object);

// Reads the study of the rubric's lab. False with a message, also when none was recorded.
bool recorded_study_load(RecordedStudy *study, const Rubric *rubric);
void recorded_study_destroy(RecordedStudy *study); // accepts a zeroed study

// Reads the scene, and its truth as a picture (see README.md). False with a message.
bool recorded_study_scene(const RecordedStudy *study, int i, Scene *scene, Image *truth);
