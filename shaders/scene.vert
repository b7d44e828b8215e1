#version 410 core
// Places an object in the world and on the screen.

#include "face_number.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_uv;

uniform mat4 u_world_from_object;
uniform mat4 u_clip_from_world;
uniform int u_object;

out vec3 v_position_world;
out vec3 v_normal_world;
out vec2 v_uv;
flat out int v_face; // of flat shapes: the number of the face among all faces, six an object

void main() {
    vec4 position_world = u_world_from_object * vec4(a_position, 1.0);
    v_position_world = position_world.xyz;
    // The inverse transpose keeps normals upright under a scale that differs by axis.
    v_normal_world = transpose(inverse(mat3(u_world_from_object))) * a_normal;
    v_uv = a_uv;
    v_face = 6 * u_object + face_number(a_normal);
    gl_Position = u_clip_from_world * position_world;
}
