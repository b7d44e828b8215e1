#version 410 core
// A magnifying glass: the shadow map around one point of the world, a little more than a disc of radius
// u_radius_texels, with one dot for each offset that belongs to u_pixel. Grey: what the map says about the
// point from there (bright: lit). Dots: yellow lit, blue dark; large the first eight.

#include "shadow_map.glsl"

in vec2 v_uv;

uniform sampler2D u_shadow_map;
uniform sampler3D u_offsets; // in the disc of radius 1, two a texel
uniform vec3 u_position_world;
uniform vec3 u_pixel;
uniform float u_radius_texels;

out vec4 o_color;

const float SHOWN = 1.15; // half the side of the picture; the disc has radius 1

vec3 position_map;

bool is_lit(vec2 offset) {
    vec2 radius = u_radius_texels / vec2(textureSize(u_shadow_map, 0));
    return texture(u_shadow_map, position_map.xy + offset * radius).r >= position_map.z;
}

void draw_dot(vec2 here, vec2 offset, int sample_number) {
    if (distance(here, offset) < (sample_number < 8 ? 0.09 : 0.06))
        o_color.rgb = is_lit(offset) ? vec3(1.0, 0.85, 0.2) : vec3(0.1, 0.2, 0.7);
}

void main() {
    vec2 here = SHOWN * (2.0 * v_uv - 1.0);
    float outside;
    find_in_shadow_map(u_position_world, position_map, outside);
    o_color = vec4(vec3(is_lit(here) ? 0.8 : 0.4), 1.0);
    if (abs(length(here) - 1.0) < 0.015)
        o_color.rgb = vec3(0.6, 0.1, 0.1);
    ivec3 size = textureSize(u_offsets, 0);
    if (size.z < 4) // not made yet: the driver stands in with a texture of its own
        return;
    ivec2 pattern = ivec2(u_pixel.xy) % size.xy;
    for (int layer = size.z - 1; layer >= 0; layer--) {
        vec4 offsets = texelFetch(u_offsets, ivec3(pattern, layer), 0);
        draw_dot(here, offsets.zw, 2 * layer + 1);
        draw_dot(here, offsets.xy, 2 * layer);
    }
}
