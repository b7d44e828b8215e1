#version 410 core
// The scene with its first light.

#include "lighting.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

uniform float u_brightness = 1.0;

out vec4 o_color;

void main() {
#ifdef SOLUTION // @N@.1
    vec3 light = phong_ambient() + phong_diffuse_specular(0, v_position_world, v_normal_world);
#else
    // TODO(@N@.1): the light of the lamp and the ambient light. Look up: phong_ambient and
    // phong_diffuse_specular in shaders/lighting.glsl. Until then: the normals.
    vec3 light = 0.5 + 0.5 * normalize(v_normal_world);
#endif
    o_color = vec4(u_brightness * light, 1.0);
}
