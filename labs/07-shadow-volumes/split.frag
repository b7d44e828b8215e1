#version 410 core
// The scene's light in two parts: what a shadow leaves and what it takes away.

#include "lighting.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

// TODO(7.2): a second output, o_diffuse_specular, for the colour attachment 1.
layout(location = 0) out vec4 o_ambient;

void main()
{
    vec3 ambient = phong_ambient();
    vec3 diffuse_specular = phong_diffuse_specular(0, v_position_world, v_normal_world);
    // TODO(7.2), second part: write each part of the light to its own output. Until then there is one picture, lit and
    // without shadows.
    o_ambient = vec4(ambient + diffuse_specular, 1.0);
}
