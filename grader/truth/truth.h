// What light really does in a scene: rays through the pixels that a lab draws, and from there to the lights,
// by Embree (Wald et al.: Embree, a Kernel Framework for Efficient CPU Ray Tracing, SIGGRAPH 2014). No GL.
//
// Faces. Primary rays meet front faces only, as the labs cull back faces: a camera looks through a plane's
// back. Rays to a light are blocked by a triangle from both sides. For closed meshes that is the same; a
// plane is a thin sheet, and whether a method lets light through its back is a property of the method that
// must show as its error.
//
// Rays end at nothing but triangles: a spot light's map, its planes and its angle are the labs' affair. Only
// the hemisphere behind a spot light is dark, as in shaders/shadow_map.glsl.
#pragma once

#include "scene/mesh.h"
#include "scene/scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    TRUTH_NONE = -1,          // no object
    TRUTH_MAX_SAMPLES = 4096, // of a query
    TRUTH_MAX_ACROSS = 16,    // of a pixel
    TRUTH_THREADS = 2
};

// A scene ready for rays.
typedef struct Truth {
    Scene scene; // a copy
    Mesh meshes[SHAPE_COUNT];
    struct RTCDeviceTy *device; // owned
    struct RTCSceneTy *tree;    // owned; geometry ids are the objects' numbers
} Truth;

// A point to be lit. Hits may also be made by hand, of any points.
typedef struct TruthHit {
    int32_t object,
        triangle;      // number in the scene and in the mesh (gl_PrimitiveID); TRUTH_NONE for the background
    vec3s position;    // world, on the triangle
    vec3s face_normal; // unit, world, of the triangle
    vec3s normal;      // unit, world, interpolated from the vertices as shaders/scene.vert does
} TruthHit;

// Row 0 is the top row, as in Image.
typedef struct TruthPicture {
    int width, height;
    TruthHit *hits; // width * height, owned
} TruthPicture;

typedef enum TruthKind {
    TRUTH_LIGHT,     // the scene's light `light`: 0 or 1; of a lamp with an extent the share that is seen
    TRUTH_LIGHTS,    // the mean of that over the scene's lights
    TRUTH_DISC,      // the share of an area light that is seen, by its area
    TRUTH_RECTANGLE, // the same
    TRUTH_OCCLUSION, // 1 - cosine-weighted ambient occlusion, around the triangle's normal
    TRUTH_DUST       // what the dust before the point sends to the eye of light `light`: see truth/dust.h
} TruthKind;

// A flat light: its points are center + a * right + b * up, with |a|, |b| <= 1 for a rectangle and a^2 + b^2
// <= 1 for a disc. Shines from both sides.
typedef struct TruthArea {
    vec3s center, right, up; // world
} TruthArea;

// Samples are stratified and drawn again for each tile of 4 x 4 pixels, whose pixels share them.
typedef struct TruthQuery {
    TruthKind kind;
    int light;       // TRUTH_LIGHT, TRUTH_DUST
    TruthArea area;  // TRUTH_DISC, TRUTH_RECTANGLE
    int samples;     // rays a pixel, 1..TRUTH_MAX_SAMPLES (and a light, if one has an extent): area light and
                     // occlusion
    float limit;     // TRUTH_OCCLUSION: length of the rays, world units; 0: no limit
    uint64_t seed;   // the same seed gives the same bytes
    int parts, part; // area light and occlusion, `parts` a square of a whole number that divides the grid of
                     // strata: only the part-th of so many shares of them; 0: all
    bool one_by_one; // the same rays one at a time, for comparison
} TruthQuery;

// Takes the meshes of common/scene/mesh.h, placed in the world. False with a message, also for objects that
// no lab can draw (scene_check).
bool truth_create(Truth *truth, const Scene *scene);
void truth_destroy(Truth *truth); // accepts a zeroed truth

// Memory for the hits of width x height pixels, all of them background. False with a message.
bool truth_picture_create(TruthPicture *picture, int width, int height);
void truth_picture_destroy(TruthPicture *picture); // accepts a zeroed picture

// Fills the picture with what the scene's camera sees through the pixels' centres between its near and far
// plane.
void truth_look(const Truth *truth, TruthPicture *picture);

// Where in its pixel a ray passes: in stratum `part` of a grid of `across` x `across`, at a random place that
// differs from pixel to pixel. Each pixel counts its strata in another order, so that what else goes by
// `part` (TruthQuery) goes with each place alike; `across` is a power of two, at most TRUTH_MAX_ACROSS.
typedef struct TruthPlace {
    int across, part;
    uint64_t seed;
} TruthPlace;

// As truth_look, but through these places in the pixels.
void truth_look_within(const Truth *truth, TruthPicture *picture, const TruthPlace *place);

// Visibility in 0..1 of each pixel of the picture, 0 for the background (the labs' visibility view is black
// there) but for dust. False with a message for a light that the scene does not have, a number of samples out
// of range, a medium that medium_check refuses.
bool truth_trace(const Truth *truth, const TruthPicture *picture, const TruthQuery *query, float *visibility);

// Do the lights of the query need samples, since one of them has an extent?
bool truth_is_wide(const Scene *scene, const TruthQuery *query);

// Does the query's visibility have values between 0 and 1: occlusion, or a light with an extent?
bool truth_is_soft(const Scene *scene, const TruthQuery *query);

// dot(normal, direction to the light) as shaders/lighting.glsl has it, or that of the triangle where it is
// less: what light grazes by either is no fair test of a shadow. Of light `light`; for TRUTH_NONE the largest
// over all lights. -1..1; -1 for the background.
float truth_facing(const Scene *scene, const TruthHit *hit, int light);
