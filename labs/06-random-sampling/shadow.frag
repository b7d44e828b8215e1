#version 410 core
// The scene with the shadow of light 0, softened by random samples. Uralsky: Efficient Soft-Edged Shadows
// Using Pixel Shader Branching, GPU Gems 2, chapter 17, 2005.

#include "lighting.glsl"
#include "shadow_map.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

uniform sampler2D u_shadow_map;
uniform sampler3D u_offsets;  // in the disc of radius 1: two a texel (xy and zw), the outermost first
uniform float u_pattern_size; // width and height of u_offsets
uniform int u_layers;         // its depth
uniform float u_radius;       // of the disc, as a part of the map's side
uniform bool u_early_out;

out vec4 o_color;

// Given: 1 where the map sees nothing in front of `depth`, else 0.
float tap(vec2 place, float depth) {
    return texture(u_shadow_map, place).r < depth ? 0.0 : 1.0;
}

// How many of the two samples in one texel of the pattern are lit: 0, 1 or 2.
float lit_of_two(ivec3 texel, vec3 position_map) {
    // TODO(6.4): read the texel's two offsets, bring them from the disc of radius 1 to one of u_radius and
    // tap the map around position_map.xy. Look up: texelFetch.
    return 2.0 * tap(position_map.xy, position_map.z);
}

// The share of light 0 that reaches the point.
float visibility(vec3 position_world) {
    vec3 position_map;
    float outside;
    if (!find_in_shadow_map(position_world, position_map, outside))
        return outside;
    ivec2 pattern = ivec2(0);
    // TODO(6.6): each pixel has a pattern of its own until they repeat: gl_FragCoord.xy
    // modulo u_pattern_size.
    float sum = 0.0, lit = tap(position_map.xy, position_map.z);
    // TODO(6.4), second part: add up lit_of_two of the first four layers, ivec3(pattern, layer); the mean of
    // these eight samples is `lit`.
    // TODO(6.8): where the eight agree, all lit or all dark, return `lit` without the
    // others; only if u_early_out.
    // TODO(6.7): add the samples of the layers 4 to u_layers - 1; `lit` is the mean of all samples.
    return lit;
}

void main() {
    float lit = visibility(v_position_world);
    o_color = vec4(phong_ambient() + lit * phong_diffuse_specular(0, v_position_world, v_normal_world), 1.0);
}
