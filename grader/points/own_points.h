// Measures a student's lab in the settings of a recorded study.
#pragma once

#include "exam/worker_client.h"
#include "points/recorded_study.h"

#include <stdbool.h>

enum { OWN_MESSAGE = 300 };

typedef struct OwnPoint {
    bool drawn; // false: `message` says why not
    char message[OWN_MESSAGE];
    double error, milliseconds;
} OwnPoint;

// Who draws: the student's files, or those that were handed out.
typedef struct OwnLab {
    const Rubric *rubric;
    WorkerClient client; // its folder is a temporary one
    char *original;      // the text of the shader that was edited last, owned
    const char *edited;  // its file; NULL: none
} OwnLab;

// Compiles the files of `folder`, which is their author's own: outside the jail. False with a message.
bool own_lab_open(OwnLab *lab, const Rubric *rubric, const char *folder, ContextKind context);
void own_lab_close(OwnLab *lab); // accepts a zeroed lab

// Draws the scene in the point's setting and compares it with the truth.
void own_lab_measure(OwnLab *lab, const RecordedPoint *point, const Scene *scene, const Image *truth,
                     OwnPoint *own);

// The time of a frame of the scene with the default knobs, milliseconds; false with a message.
bool own_lab_yardstick(OwnLab *lab, const Scene *scene, int width, int height, double *milliseconds);

// The mean difference between a frame of the visibility and the truth over the pixels that count; a pixel
// without a finite colour counts as wholly wrong. Both have one size.
double own_points_error(const Image *frame, const Image *truth);
