// The colours of the handouts' pictures. A variant that is graded draws its colours by chance; a picture that
// is looked at for long has few and quiet ones: what receives shadows is pale, what throws them is clear.
#pragma once

#include "scene/scene.h"

// Gives the scene's objects and its background the colours of the palette. Objects that had one colour get
// one again.
void picture_colors_apply(Scene *scene);
