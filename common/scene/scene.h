// What a frame shows: a few objects, a light, a camera. Plain data without pointers, so that it crosses a
// pipe. No GL.
#pragma once

#include "scene/mathx.h"
#include "scene/mesh.h"
#include "scene/random.h"

#include <stdbool.h>
#include <stdint.h>

enum { SCENE_MAX_OBJECTS = 16, SCENE_MAX_LIGHTS = 4 };

typedef struct Object {
    int32_t shape;           // a Shape
    int32_t is_screen;       // 1: shows a texture instead of its colour (lab 02)
    mat4s world_from_object; // rotation, translation and scale; no shear
    vec3s color;             // linear, 0..1
    float specular, shininess;
} Object;

typedef enum LightKind { LIGHT_SPOT, LIGHT_DIRECTIONAL, LIGHT_POINT } LightKind;

// All have a position, where their shadow map is taken, and look at `target`. A directional light sends
// parallel rays from position to target, a spot light rays from its position forwards, a point light rays
// from its position in all directions.
typedef struct Light {
    int32_t kind;
    vec3s position, target; // world
    vec3s color;
    float fov_y;     // spot: full angle of the square map, radians
    float half_size; // directional: half the side of the square map, world units
    float extent;    // spot and point: half the side of a square lamp around the position, at right angles to
                     // the line to the target, world units; 0: a lamp without a size
    float near_plane, far_plane;
} Light;

typedef struct Camera {
    vec3s eye, target; // world; up is +y, where it gives a view
    float fov_y;       // radians
    float near_plane, far_plane;
} Camera;

// The dust in the air, the same everywhere up to the camera's far plane: of the light that travels dt,
// scattering * dt is sent into all directions alike and extinction * dt is lost. Per world unit, finite, at
// least 0; both 0: clear air. Light loses nothing on its way from a light to the dust, as it does on no way
// to a surface.
typedef struct Medium {
    float scattering, extinction;
} Medium;

typedef struct Scene {
    Object objects[SCENE_MAX_OBJECTS];
    Light lights[SCENE_MAX_LIGHTS];
    Camera camera;
    Camera second_camera; // what the screen shows (lab 02)
    vec3s ambient;        // colour of the ambient light
    vec3s background;
    Medium medium;
    int32_t object_count, light_count;
} Scene;

// A scene by its name with everything that may vary drawn from `random`. False for an unknown name (the
// message lists the names) and for a medium that medium_check refuses.
bool scene_make(Scene *scene, const char *name, Random *random);

// Can each object be drawn: is none mirrored, which would turn its faces inside out, and none flat or of
// numbers that are not finite, which has no normals? False with a message that names the object. scene_make
// and the truth ask.
bool scene_check(const Scene *scene);

// Name of the i-th scene, NULL past the last.
const char *scene_name(int i);

// Are both numbers of the medium finite and at least 0? False with a message.
bool medium_check(const Medium *medium);

// A camera that looks straight up or down has -z for its up vector, for +y gives no view there. So has a
// light.
//
// From the world to the camera, which looks along -z there.
mat4s camera_view_from_world(const Camera *camera);

// aspect = width / height of the picture.
mat4s camera_clip_from_view(const Camera *camera, float aspect);

// Does the light look straight up or down, so that +y cannot be its up vector?
bool light_is_overhead(const Light *light);

// From the world to such a light, with -z as its up vector.
mat4s light_view_from_overhead(const Light *light);

// The unit vectors to the right and up of the light's map, in the world. A square lamp is position + a *
// right + b * up with |a|, |b| <= extent.
void light_axes(const Light *light, vec3s *right, vec3s *up);
