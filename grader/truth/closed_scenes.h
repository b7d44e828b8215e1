// Scenes made by hand, for what holds a lab's picture against a closed form.
#pragma once

#include "scene/scene.h"

// A white wall in the plane z = 0 that faces +z, half_size wide, seen straight on from (0, 0, distance) so
// that one world unit of the wall covers the same number of pixels everywhere. No light yet.
Scene closed_wall(float half_size, float distance, float fov_y);

// Degrees in radians.
double closed_radians(double degrees);

// World units of the wall per pixel of a picture `height` pixels high.
double closed_unit(const Scene *scene, int height);

// Adds an object; `turn` in degrees about +y.
void closed_add(Scene *scene, Shape shape, vec3s center, vec3s half_size, float turn);

// Adds a light. Of fov_y and half_size the one counts that its kind has; angles in radians.
void closed_light(Scene *scene, LightKind kind, vec3s position, vec3s target, float fov_y, float half_size,
                  float near_plane, float far_plane);

// A wall under parallel light along -to_light with a box before it, the camera 10 before the wall: the eye
// may be moved into the box's shadow.
Scene closed_wall_and_box(vec3s to_light, vec3s center, vec3s half_size);

// Adds a plane that stands at `middle` and faces +z, and is then turned about +y (degrees).
void closed_stand(Scene *scene, vec3s middle, float half_width, float half_height, float turn);

enum { CLOSED_LAMP_AT = 8 };

// The wall of which a picture of width x height pixels shows 3.2 units across, and a spot light that looks
// straight at it from CLOSED_LAMP_AT before it: so far aside that plates do not hide from the eye where their
// shadows end.
Scene closed_wall_and_lamp(int width, int height);

// A plate parallel to that wall, h before it, from far left to where its shadow ends at x = `end` of the
// wall.
void closed_plate(Scene *scene, double h, double end);

// What a texel of that light's map, `size` texels along a side, measures on the wall.
double closed_lamp_texel(int size);

// Ambient occlusion, cosine-weighted, of a floor at the distance x from an endless wall of height h: (1 - x /
// sqrt(x^2 + h^2)) / 2.
double closed_beside_wall(double x, double h);
