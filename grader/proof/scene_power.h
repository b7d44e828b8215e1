// What a scene's objects are worth to the rubric: which mistakes would other checks see if one were not
// there? An object is needed when, without it in the scene's variants of a check,
// - the grader would not ask one of these variants any more (exam_acceptable), or
// - a known mistake that fails in them would pass, or the other way round, as if the check had no others.
// Pixels that merely change (scene_needs.h) are no reason by themselves: more boxes would change more of
// them.
#pragma once

#include "exam/exam.h"

#include <stdbool.h>
#include <stdint.h>

// Does a variant of this scene in the exam have it (scene_needs_has)?
bool scene_power_has(const Exam *exam, const char *scene, int thing);

enum { POWER_TEXT = 300 };

// Objects of a scene, and behind SCENE_MAX_OBJECTS lights: bit n is thing n.
typedef uint32_t PowerThings;

// Is one of these things needed in the exam, when all of them are taken away together? `why` gets the first
// check that says so, and what happens; "" when none does. False with a message when ours cannot be drawn.
bool scene_power_find(Exam *exam, const char *scene, PowerThings things, char why[POWER_TEXT]);
