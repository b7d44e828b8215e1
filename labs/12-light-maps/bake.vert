#version 410 core
// Draws in texture space: each face goes to its chart, not to where a camera sees it.

#include "face_number.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_uv; // the place on the face, in [0, 1] x [0, 1]

uniform mat4 u_world_from_object;
uniform int u_object;
uniform vec4 u_charts[96];     // of each face: left, bottom, width, height of its chart, luxels
uniform int u_width, u_height; // of the light map, luxels

out vec3 v_position_world;
out vec3 v_normal_world;

void main() {
    v_position_world = (u_world_from_object * vec4(a_position, 1.0)).xyz;
    v_normal_world = transpose(inverse(mat3(u_world_from_object))) * a_normal;
    vec4 chart = u_charts[6 * u_object + face_number(a_normal)];
    // TODO(12.1): where in the light map, in luxels, does this vertex lie (lab 08: a_uv = (0, 0) is the
    // chart's lower left corner)? The light map's left edge is x = -1 and its right edge x = 1; y likewise.
    gl_Position = vec4(2.0 * a_uv - 1.0, 0.0, 1.0);
}
