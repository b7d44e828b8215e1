// How a caster is pressed flat onto a receiver. Points are (x, y, z, 1), a plane P = (n, d) holds the points
// p with P . p = 0, and P . p is the height over it in world units.
#pragma once

#include "lab.h"

// The plane of a receiver, a SHAPE_PLANE: in its object space y = 0, seen from +y.
static vec4s receiver_plane(const Object *receiver) {
    vec3s normal = glms_vec3_normalize(glms_vec3(receiver->world_from_object.col[1]));
    vec3s point = glms_vec3(receiver->world_from_object.col[3]);
    return glms_vec4(normal, -glms_vec3_dot(normal, point));
}

// The noon sun stands straight above a level receiver: the shadow of (x, y, z) falls to the same x and z.
static mat4s flatten_noon(vec4s plane) {
    mat4s flat_from_world = glms_mat4_identity();
    // TODO(10.2): change two elements so that y becomes the receiver's height, whatever y was. The plane is
    // (0, 1, 0, -height) here; raw[column][row].
    UNUSED(plane);
    return flat_from_world;
}

// The light as a point: a lamp at its position, a sun in its direction, infinitely far.
static vec4s light_point(const Light *light, vec3s position) {
    vec4s point = glms_vec4(position, 1);
    // TODO(10.4): a sun (LIGHT_DIRECTIONAL) has no place: from light->target to `position` is the direction
    // to it. What is w of a point at infinity?
    UNUSED(light);
    return point;
}

// From a point to its shadow on the plane: where the line through it and the light meets the plane.
static mat4s flatten(vec4s plane, vec4s light) {
    mat4s flat_from_world = glms_mat4_identity();
    // TODO(10.3): M = (P . L) I - L P^T, with P the plane and L the light. Row r and column c of L P^T hold
    // L_r P_c; raw[column][row]. Until then a caster is its own shadow.
    UNUSED(plane, light);
    return flat_from_world;
}

// Given: two numbers in [-0.5, 0.5) for a cell, always the same ones.
static vec2s cell_jitter(int column, int row) {
    uint32_t a = 2654435769u * (uint32_t)(64 * row + column + 1);
    a = (a ^ (a >> 15)) * 2246822519u;
    a = (a ^ (a >> 13)) * 3266489917u;
    a ^= a >> 16;
    return (vec2s){{(float)(a & 0xffff) / 65536 - 0.5f, (float)(a >> 16) / 65536 - 0.5f}};
}

// A wide lamp is cut into n x n cells. The place of the small lamp that stands for one of them: the cell's
// middle, moved by jitter * cell_jitter, whose unit is one cell.
static vec3s lamp_position(const Light *light, int n, int column, int row, float jitter) {
    vec3s position = light->position, right, up;
    light_axes(light, &right, &up);
    vec2s aside = cell_jitter(column, row);
    // TODO(10.9): the lamp's points are position + a * right + b * up with a and b from -extent to extent:
    // `column` of n goes along a, `row` of n along b. Until then all lamps stand in the middle.
    UNUSED(n, jitter, aside);
    return position;
}
