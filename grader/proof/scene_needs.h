// Does a scene hold more than it needs? Takes each object and, where there are several, each light of it away
// and looks at what is graded then.
//
// What a check is about, its *phenomenon*, is what the solution draws on the pixels where the solution
// without the check's task draws something else, in the check's view. An object or a light is needed when its
// absence changes that, or when the grader would not ask the variant any more (exam_acceptable).
#pragma once

#include "exam/exam.h"

#include <stdbool.h>

enum { ECONOMY_MAX_SCENES = 16, ECONOMY_TEXT = 128, ECONOMY_THINGS = SCENE_MAX_OBJECTS + SCENE_MAX_LIGHTS };

// A scene as the checks of one lab use it.
typedef struct SceneNeeds {
    const char *scene; // lives as long as the program
    Scene first;       // its first variant
    // Of each object, and behind SCENE_MAX_OBJECTS of each light: the share of the picture, 0..1, whose
    // phenomenon changes without it, 1 where the variant would be refused. The mean over a check's variants,
    // of these the largest over checks and seeds. Shading cannot do without a light: an only one is not
    // judged. In the visibility view each of several has a share of the white, and so is needed.
    double need[ECONOMY_THINGS];
} SceneNeeds;

// Measures the scenes of a lab, at most ECONOMY_MAX_SCENES, in the order of scene_name; returns their number,
// -1 with a message when a frame of ours fails. What reaches `enough` is not looked at again; with nothing
// else left no further seed is drawn. `worker` draws; it is started when it does not run.
int scene_needs_measure(SceneNeeds *economies, const Rubric *rubric, WorkerClient *worker, int seeds,
                        double enough);

// The same for one exam, whose scenes may hold something else than scene_make puts there: looks at all
// of `economy` that is below `enough`. False with a message.
bool scene_needs_look(SceneNeeds *economy, const Exam *exam, Painters *roster, double enough);

// The least of the needs of all objects and lights but those that scene_needs_excuse names.
double scene_needs_least(const SceneNeeds *economy);

// Does the scene have this object, or behind SCENE_MAX_OBJECTS this light, and may it be taken away?
bool scene_needs_has(const Scene *scene, int thing);

// Takes it away; those behind it move up.
void scene_needs_take_away(Scene *scene, int thing);

// Why this object is in the scene though no check sees it; NULL when there is no excuse.
const char *scene_needs_excuse(const char *scene, int object);

// Triangles of all objects of a scene: what each pass draws.
int scene_needs_triangles(const Scene *scene);

// What the scene is made of, as the table in grader/proof/SCENES.md says it: "| lab | scene | planes | boxes
// | spheres | triangles |".
void scene_needs_describe(char text[ECONOMY_TEXT], const char *lab, const SceneNeeds *economy);
