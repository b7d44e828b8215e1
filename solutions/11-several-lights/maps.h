// The list of a frame's maps, and the array texture that holds them.
#pragma once

#include "lab.h"
#include "shadow_map.h"

#include <stdio.h>

enum { KNOB_SHADOWS, KNOB_MAP_SIZE, KNOB_LAMPS, KNOB_JITTER, KNOB_SEAMS };
enum { PROGRAM_DEPTH, PROGRAM_SHADE };
enum { MOST_MAPS = 64 };

// A light has one map, a wide spot light n x n, and a LIGHT_POINT none here (it has a cube).
typedef struct MapList {
    Light lights[MOST_MAPS]; // what map k is drawn for: a light, or one small lamp of a wide one
    int count;
    vec4s of_light[SCENE_MAX_LIGHTS]; // for the shader: first map, number of maps, near plane, far plane
} MapList;

// Given: filters and comparison of a depth texture that is bound. A lookup compares four texels and blends.
static void set_comparison(GLenum target) {
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(target, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

// An array of `layers` depth maps of size x size texels.
static GLuint create_map_array(int size, int layers) {
    GLuint texture = 0;
#ifdef SOLUTION // 11.1
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT24, size, size, layers, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, NULL);
    set_comparison(GL_TEXTURE_2D_ARRAY);
#else
    // TODO(11.1): make a texture of the target GL_TEXTURE_2D_ARRAY with GL_DEPTH_COMPONENT24, and give it
    // set_comparison. Look up: glTexImage3D, whose depth is the number of layers here.
    UNUSED(size, layers, set_comparison);
#endif
    return texture;
}

// Given: two numbers in [-0.5, 0.5) for a cell, always the same ones (those of lab 10).
static vec2s cell_jitter(int column, int row) {
    uint32_t a = 2654435769u * (uint32_t)(64 * row + column + 1);
    a = (a ^ (a >> 15)) * 2246822519u;
    a = (a ^ (a >> 13)) * 3266489917u;
    a ^= a >> 16;
    return (vec2s){{(float)(a & 0xffff) / 65536 - 0.5f, (float)(a >> 16) / 65536 - 0.5f}};
}

// A wide light is cut into n x n cells: the small lamp that stands for one of them, at the cell's middle
// moved by jitter * cell_jitter, whose unit is one cell. It looks in the direction of the whole light.
static Light small_lamp(const Light *light, int n, int column, int row, float jitter) {
    Light lamp = *light;
    vec3s right, up;
    light_axes(light, &right, &up);
    vec2s aside = cell_jitter(column, row);
#ifdef SOLUTION // 11.7
    float a = light->extent * (2 * ((float)column + 0.5f + jitter * aside.x) / (float)n - 1);
    float b = light->extent * (2 * ((float)row + 0.5f + jitter * aside.y) / (float)n - 1);
    vec3s offset = glms_vec3_add(glms_vec3_scale(right, a), glms_vec3_scale(up, b));
    lamp.position = glms_vec3_add(light->position, offset);
    lamp.target = glms_vec3_add(light->target, offset);
#else
    // TODO(11.7): the light's points are position + a * right + b * up with a and b from -extent to extent:
    // `column` of n goes along a, `row` of n along b (as in lab 10). So that all small lamps look in the same
    // direction, the target must be moved as the position is. Until then all stand in the middle.
    UNUSED(n, jitter, aside);
#endif
    return lamp;
}

static bool is_wide(const Light *light) {
    return light->kind == LIGHT_SPOT && light->extent > 0;
}

static int count_maps(const Light *light, int n) {
    if (light->kind == LIGHT_POINT)
        return 0;
    return is_wide(light) ? n * n : 1;
}

// Given: how many layers are enough for any scene.
static int most_maps(const Frame *frame) {
    int n = (int)frame->knobs[KNOB_LAMPS], most = SCENE_MAX_LIGHTS * n * n;
    return most < MOST_MAPS ? most : MOST_MAPS;
}

// Given: all maps of the frame. Where MOST_MAPS are too few, wide lights are cut into fewer small lamps.
static MapList list_maps(const Frame *frame) {
    const Scene *scene = frame->scene;
    MapList list = {0};
    int n = (int)frame->knobs[KNOB_LAMPS] + 1, total = MOST_MAPS + 1;
    while (total > MOST_MAPS) {
        n--;
        total = 0;
        for (int i = 0; i < scene->light_count; i++)
            total += count_maps(&scene->lights[i], n);
    }
    for (int i = 0; i < scene->light_count; i++) {
        const Light *light = &scene->lights[i];
        int first = list.count, maps = count_maps(light, n);
        for (int k = 0; k < maps; k++)
            list.lights[list.count++] =
                is_wide(light) ? small_lamp(light, n, k % n, k / n, frame->knobs[KNOB_JITTER]) : *light;
        list.of_light[i] = (vec4s){{(float)first, (float)maps, light->near_plane, light->far_plane}};
    }
    return list;
}
