// Given: the maps, and where a point lies in one of them. See maps.h.

#include "lighting.glsl"

uniform sampler2DArray u_maps;         // layer i: depths in [0, 1] as the sun sees slice i
uniform mat4 u_map_clip_from_world[4]; // the matrices with which they were drawn
uniform int u_count;                   // of the slices
uniform vec4 u_ends;                   // where each slice ends: distance before the eye along the axis
uniform vec4 u_texels;                 // side of a texel of each map, world units
uniform vec3 u_axis_world;             // unit vector, where the camera looks
uniform float u_near;                  // of the camera: slice 0 begins there
uniform float u_blend;                 // the part of a slice that is blended into the next
uniform float u_offset;                // how far a point is moved along its normal, texels; 0: not at all
uniform bool u_show_slices;            // the stage "slices"

// True when the map says something about the point; position_map is then its place in the map (xy) and its
// depth (z).
bool find_in_map(int slice, vec3 position_world, out vec3 position_map) {
    position_map = (u_map_clip_from_world[slice] * vec4(position_world, 1.0)).xyz * 0.5 + 0.5;
    return position_map.z <= 1.0 && all(greaterThanEqual(position_map.xy, vec2(0.0))) &&
           all(lessThanEqual(position_map.xy, vec2(1.0)));
}

vec3 slice_color(int slice) {
    return vec3(slice == 0 || slice == 3, slice == 1 || slice == 3, slice == 2) * 0.9 + 0.1;
}
