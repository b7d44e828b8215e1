// The shadow map of one light, finished: what lab 03 builds by hand, for the labs after it. The shader's side
// is shaders/shadow_map.glsl. Williams: Casting Curved Shadows on Curved Surfaces, SIGGRAPH 1978.
#pragma once

#include "gl.h"
#include "scene/mathx.h"
#include "scene/scene.h"

#include <stdbool.h>

typedef struct ShadowMap {
    GLuint framebuffer;
    GLuint texture; // depth, GL_NEAREST, border with depth 1, no comparison
    int size;       // width and height, texels
} ShadowMap;

// `depth_format` is GL_DEPTH_COMPONENT16, 24 or 32F.
bool shadow_map_create(ShadowMap *map, int size, GLenum depth_format);
void shadow_map_destroy(ShadowMap *map); // accepts a zeroed map

// The light's matrix: perspective for a spot light, orthographic for a directional one.
mat4s shadow_map_clip_from_world(const Light *light);

// Binds the map's framebuffer, sets the viewport to all of it and clears its depth.
void shadow_map_begin(const ShadowMap *map);
