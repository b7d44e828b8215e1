// An atlas: one texture for all flat faces of a scene, each in a rectangle of its own, its chart. No GL.
#pragma once

#include "scene/scene.h"

#include <stdbool.h>

enum { ATLAS_FACES = 6, ATLAS_MAX_CHARTS = SCENE_MAX_OBJECTS * ATLAS_FACES, ATLAS_MAX_SIZE = 2048 };

// A place on the face is given by (s, t) in [0, 1] x [0, 1], its mesh's texture
// coordinates (v_uv in shaders).
typedef struct Chart {
    int left, bottom;        // the chart's first texel in the atlas
    int width, height;       // its texels; the padding lies around them and belongs to this chart alone
    vec3s corner;            // world: the place with (s, t) = (0, 0)
    vec3s side_s, side_t;    // world: from there to (1, 0) and to (0, 1)
    vec3s right, up, normal; // world, unit length, at right angles: along the sides and outwards
} Chart;

typedef struct Atlas {
    Chart charts[ATLAS_MAX_CHARTS];
    int chart_count;
    int width, height, padding;         // texels
    float *texels;                      // width * height, the lowest row first, owned
    vec4s rectangles[ATLAS_MAX_CHARTS]; // by a shader's v_face: left, bottom, width, height; zeros where
                                        // there is no chart
} Atlas;

// Gives each face of the scene's planes and boxes (of no other shapes) a chart of so many
// texels per world unit, at least one, with `padding` texels on all sides. All texels are set to 1. `atlas`
// is zeroed or was laid out before. False with a message for an atlas that is too large, and for a plane or a
// box that is mirrored or flat.
bool atlas_layout(Atlas *atlas, const Scene *scene, float texels_per_unit, int padding);
// Instead of what was baked, gives each texel a value in [0, 1) by its column and row in the atlas.
void atlas_number_texels(Atlas *atlas);
void atlas_destroy(Atlas *atlas); // accepts a zeroed atlas

// The place (s, t) of a chart's face in the world.
vec3s atlas_position(const Chart *chart, float s, float t);
