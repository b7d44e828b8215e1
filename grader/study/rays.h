// Ray tracing itself as a method, beside the labs' methods.
#pragma once

#include "study/views.h"

// Adds it with 1, 4, 16, 64 and 256 rays a pixel.
void rays_add_methods(MethodList *list);

// Draws the view by so many rays a pixel to the light (and as many from the camera, each through another
// place in the pixel; a single one through its centre): other random numbers than the truth's. `ms` is the
// processor's time for the tree of the scene and for the rays. False with a message.
bool rays_draw(const StudyView *view, const StudyScene *scene, int rays, float *visibility,
               MeasuredTime *time);
