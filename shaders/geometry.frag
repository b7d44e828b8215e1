#version 410 core
// What the camera sees in every pixel, for passes that work on the picture (see view_space.glsl).

in vec3 v_position_world;
in vec3 v_normal_world;

uniform mat4 u_view_from_world;

out vec4 o_geometry; // normal in view space; distance in front of the camera, along its axis

void main() {
    vec3 normal_view = mat3(u_view_from_world) * normalize(v_normal_world);
    o_geometry = vec4(normal_view, -(u_view_from_world * vec4(v_position_world, 1.0)).z);
}
