#version 410 core
// The scene's light in two parts: what a shadow leaves and what it takes away.

#include "lighting.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

layout(location = 0) out vec4 o_ambient;
layout(location = 1) out vec4 o_diffuse_specular; // for the colour attachment 1

void main() {
    vec3 ambient = phong_ambient();
    vec3 diffuse_specular = phong_diffuse_specular(0, v_position_world, v_normal_world);
#ifdef SOLUTION // 7.2
    o_ambient = vec4(ambient, 1.0);
    o_diffuse_specular = vec4(diffuse_specular, 1.0);
#else
    // TODO(7.2): write each part of the light to its own output. Until then the second gets nothing: all lies
    // in ambient light.
    o_ambient = vec4(ambient, 1.0);
    o_diffuse_specular = vec4(0.0, 0.0, 0.0, 1.0);
#endif
}
