#version 410 core
// One luxel: the light that its place receives. Alpha is 1 where a face lies, and stays 0 elsewhere.

#include "light.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

uniform sampler2D u_by_rays; // of each luxel the share of the lamp that it sees
uniform sampler2D u_still;   // the shadow map of what stands still
uniform int u_shadows;       // the knob: none, by rays, by a map
uniform int u_pattern;       // the knob: light, stripes, numbers

out vec4 o_luxel;

vec3 light() {
    vec3 light = irradiance(v_position_world, v_normal_world);
    if (u_shadows == 1)
        light *= texelFetch(u_by_rays, ivec2(gl_FragCoord.xy), 0).r;
    if (u_shadows == 2)
        light *= map_visibility(u_still, v_position_world);
    return light;
}

// Instead of light: stripes that go on from face to face, or a number in each luxel.
vec3 test_pattern() {
    ivec2 luxel = ivec2(gl_FragCoord.xy);
    if (u_pattern == 2)
        return vec3((5 * luxel.x + 3 * luxel.y) % 16, (3 * luxel.x + 7 * luxel.y) % 16,
                    (7 * luxel.x + 5 * luxel.y) % 16) /
               16.0;
    return 0.5 + 0.5 * sin(vec3(3, 2, 4) * v_position_world.x + vec3(4, 5, 3) * v_position_world.y +
                           vec3(5, 4, 2) * v_position_world.z);
}

void main() {
    o_luxel = vec4(u_pattern > 0 ? test_pattern() : light(), 1.0);
}
