// What scenes are built from, and the tables that hold them.
#pragma once

#include "scene/scene.h"

// Ends with an entry without a name.
typedef struct SceneMaker {
    const char *name;
    void (*make)(Scene *scene, Random *random);
} SceneMaker;

// The scenes of all labs, in the labs' order, then NULL. The file scenes*.c of a lab defines a table by
// the name LAB_TABLE; build.mk gives each file a name of its own for it and makes this list.
extern const SceneMaker *const scenes_tables[];

// A colour for one object, or for several that shall look alike: scene_make gives them one of the palette for
// it. Neither black nor white.
vec3s part_color(Random *random);

// A point at `distance` from `target`: azimuth about +y from +z, elevation above the horizon, in degrees.
vec3s part_orbit(vec3s target, float azimuth, float elevation, float distance);

// An empty scene with a camera that looks down at the origin, near and far planes of its own, and colours.
void part_begin(Scene *scene, Random *random);

// An object turned about +y by `turn` degrees.
Object *part_object(Scene *scene, Shape shape, vec3s center, vec3s half_size, float turn, vec3s color);

// A square floor at y = 0 without highlights.
Object *part_floor(Scene *scene, float half_size, Random *random);

// A light that reaches from about 4 to about 16 units before it (both differ with its position), with room
// for the table in its map.
Light *part_light(Scene *scene, LightKind kind, vec3s position, vec3s target);

// A place for a light above the origin: behind the casters as the camera sees them, left or right, so that
// shadows fall towards it. Elevations in degrees.
vec3s part_above(Random *random, float lowest, float highest, float distance);

// A box on the floor, left of the middle.
void part_box(Scene *scene, float half_height, Random *random);

// A box on the floor and a sphere above it, a little apart.
void part_casters(Scene *scene, Random *random);
