#version 410 core
// The scene with its first light and no shadow.

#include "lighting.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

out vec4 o_color;

void main() {
    o_color = vec4(phong_ambient() + phong_diffuse_specular(0, v_position_world, v_normal_world), 1.0);
}
