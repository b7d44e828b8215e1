#version 410 core
// The picture: ambient light, and of the lamp's light what no shadow has taken.

#include "lighting.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

uniform sampler2D u_taken; // for each pixel the share of the light that is taken, 0 to 1

out vec4 o_color;

// Does the surface look to the light? If not it lies in its own shadow, also called shade.
bool faces_light(vec3 position_world, vec3 normal_world) {
#ifdef SOLUTION // 10.1
    return dot(normal_world, direction_to_light(0, position_world)) > 0.0;
#else
    // TODO(10.1): compare the normal with the direction to the light. Look up: direction_to_light in
    // shaders/lights.glsl. Until then all surfaces are lit, from behind too, like thin paper.
    return true;
#endif
}

// Given: the light of the lamp on a sheet that is as bright from behind.
vec3 light_from_both_sides() {
    float facing = dot(v_normal_world, direction_to_light(0, v_position_world));
    return phong_diffuse_specular(0, v_position_world, facing < 0.0 ? -v_normal_world : v_normal_world);
}

void main() {
    float taken = min(texelFetch(u_taken, ivec2(gl_FragCoord.xy), 0).r, 1.0);
    vec3 light = faces_light(v_position_world, v_normal_world) ? light_from_both_sides() : vec3(0.0);
    o_color = vec4(phong_ambient() + (1.0 - taken) * light, 1.0);
}
