#version 410 core
// Given: what the stages show of each point that the camera sees. Black: the map says nothing about it.

#include "pcss.glsl"

in vec3 v_position_world;

uniform int u_shown; // 0: the distance of what the map holds there; 1: kernels; 2: the mean blocker

out vec4 o_color;

const float SHOWN_KERNEL = 6.0; // this part of the map's side is white

void main() {
    vec3 position_map;
    float outside, receiver = distance_of(v_position_world);
    o_color = vec4(0.0, 0.0, 0.0, 1.0);
    if (!find_in_shadow_map(v_position_world, position_map, outside))
        return;
    if (u_shown == 0)
        o_color.rgb = vec3(distance_from_depth(texture(u_shadow_map, position_map.xy).r) / u_far);
    if (u_shown == 1)
        o_color.rgb = SHOWN_KERNEL * vec3(kernel_side(u_search_from, receiver),
                                          kernel_side(mix(u_search_from, receiver, 0.3), receiver),
                                          kernel_side(mix(u_search_from, receiver, 0.6), receiver));
    if (u_shown == 2)
        o_color.rgb = vec3(mean_blocker(position_map, receiver) / u_far);
}
