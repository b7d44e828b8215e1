#version 410 core
// What the dust before a pixel scatters to the eye, summed over steps of the way.

#include "dust.glsl"
#include "shadow_map.glsl"

in vec2 v_uv;

uniform sampler2D u_shadow_map;
uniform int u_steps;
uniform float u_jitter; // 0: none, 1: a whole step

out float o_dust;

// Given: a number from 0 to 1 (less than 1) for this pixel, always the same one.
float noise() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint a = 2654435769u * (4096u * pixel.y + pixel.x + 1u);
    a = (a ^ (a >> 15)) * 2246822519u;
    a = (a ^ (a >> 13)) * 3266489917u;
    return float((a ^ (a >> 16)) >> 8) / 16777216.0;
}

// Does the light reach this point? 1 or 0.
float light_at(vec3 position_world) {
#ifdef SOLUTION // 13.5
    vec3 position_map;
    float outside;
    if (!find_in_shadow_map(position_world, position_map, outside))
        return outside;
    return position_map.z <= texture(u_shadow_map, position_map.xy).r ? 1.0 : 0.0;
#else
    // TODO(13.5): find the point in the shadow map, and compare its depth with the map's. Where the map says
    // nothing, find_in_shadow_map in shaders/ says what to take. Dust needs no bias. Until then all is lit.
    return 1.0;
#endif
}

// Of the light that is scattered at a distance from the eye: the share that gets there.
float share_that_arrives(float way) {
#ifdef SOLUTION // 13.4
    return transmittance(way);
#else
    // TODO(13.4): on its way to the eye this light crosses dust, too. Until then all of it arrives.
    return 1.0;
#endif
}

// Where in each of its steps this pixel asks for the light: from 0, where the step begins, to 1.
float place_in_step() {
#ifdef SOLUTION // 13.6
    return 0.5 + u_jitter * (noise() - 0.5);
#else
    // TODO(13.6): u_jitter of a step, with the middle of the step in the middle, from noise(). Until then all
    // pixels ask in the middle, and one sees the steps.
    return 0.5;
#endif
}

// The light that the dust between the eye and a point of the world sends to the eye.
float march(vec3 end_world) {
    float sum = 0.0;
#ifdef SOLUTION // 13.3
    float way = distance(u_eye_world, end_world), step_length = way / float(u_steps);
    for (int i = 0; i < u_steps; i++) {
        float t = (float(i) + place_in_step()) * step_length;
        vec3 position_world = mix(u_eye_world, end_world, t / way);
        sum += light_at(position_world) * share_that_arrives(t) * u_scattering * step_length;
    }
#else
    // TODO(13.3): cut the way into u_steps steps. In each of them, at place_in_step(), ask light_at the point
    // and share_that_arrives from there; on the step's length the dust scatters the share u_scattering of it
    // for each unit. Add up. Until then there is no dust.
#endif
    return sum;
}

void main() {
    o_dust = march(seen_at(v_uv));
}
