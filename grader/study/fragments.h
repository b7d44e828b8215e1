// What shadow volumes cost whoever draws them and whatever hides them: the fragments that their faces cover.
#pragma once

#include "scene/scene.h"

// Area in pixels, in a picture of this size, of all faces of the volumes of light 0 that the scene's closed
// objects cast, each counted whether or not something hides it: exactly, by clipping (Sutherland, Hodgman:
// Reentrant Polygon Clipping, CACM 1974), without a far plane. Negative, with a message, when there is no
// memory.
double fragments_of_volumes(const Scene *scene, int width, int height);
