#version 410 core
// Given: the scene in ambient light, or with its first light, too.

#include "lighting.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

uniform bool u_is_lit;

out vec4 o_color;

void main() {
    vec3 light = u_is_lit ? phong_diffuse_specular(0, v_position_world, v_normal_world) : vec3(0.0);
    o_color = vec4(phong_ambient() + light, 1.0);
}
