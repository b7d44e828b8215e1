// Percentage-closer soft shadows: the kernel of each point is as wide as its penumbra. Fernando:
// Percentage-Closer Soft Shadows, SIGGRAPH sketches, 2005.

#include "shadow_map.glsl"

uniform sampler2D u_shadow_map;
uniform float u_near, u_far; // of the light
uniform float u_map_tangent; // of half the map's angle
uniform float u_lamp_side;   // of the square lamp, world units
uniform float u_search_from; // no blocker is nearer to the lamp than this
uniform int u_search_taps;   // along a side of the search
uniform int u_filter_taps;   // along a side of the kernel
uniform bool u_fixed;        // is the kernel the same for all points?
uniform float u_fixed_side;  // then its side, as a part of the map's

// Given: the distance of a point from the lamp, along the light's axis.
float distance_of(vec3 position_world) {
    return (u_light_clip_from_world * vec4(position_world, 1.0)).w;
}

// The distance from the lamp, along the light's axis, of what the map holds with this depth in [0, 1].
float distance_from_depth(float depth) {
#ifdef SOLUTION // 14.1
    float ndc = 2.0 * depth - 1.0;
    return 2.0 * u_far * u_near / (u_far + u_near - ndc * (u_far - u_near));
#else
    // TODO(14.1): this takes the depth for a distance. Depth 0 is u_near, depth 1 is u_far, and what lies
    // between is not even: the formula stands in the handout.
    return depth;
#endif
}

// What the lamp looks like through the point: the side of the square that the rays from the lamp to a point
// `receiver` away cut out at the distance `blocker`, as a part of the map's side.
float kernel_side(float blocker, float receiver) {
#ifdef SOLUTION // 14.2
    float side = u_lamp_side * (receiver - blocker) / receiver;
    return side / (2.0 * blocker * u_map_tangent);
#else
    // TODO(14.2): the rays start u_lamp_side wide and end in a point: how wide are they at `blocker`? And how
    // wide is what the map sees there, from side to side? Their quotient is the answer.
    return 0.0;
#endif
}

// Where tap (i, j) of n x n lies in a square of side 1 around (0, 0).
vec2 tap_offset(int i, int j, int n) {
#ifdef SOLUTION // 14.3
    return (vec2(i, j) + 0.5) / float(n) - 0.5;
#else
    // TODO(14.3): all taps are in one place. Cut the square into n x n cells: a tap is in the middle of its
    // cell, and the middle of all taps is (0, 0).
    return vec2(0.0);
#endif
}

// The mean distance of what stands before the point, among the taps of the search; 0 where no tap finds
// anything.
float mean_blocker(vec3 position_map, float receiver) {
    float sum = 0.0;
    int found = 0;
#ifdef SOLUTION // 14.4
    float side = kernel_side(u_search_from, receiver);
    for (int i = 0; i < u_search_taps; i++)
        for (int j = 0; j < u_search_taps; j++) {
            vec2 place = position_map.xy + side * tap_offset(i, j, u_search_taps);
            float depth = texture(u_shadow_map, place).r;
            if (depth < position_map.z) {
                sum += distance_from_depth(depth);
                found++;
            }
        }
#else
    // TODO(14.4): look at u_search_taps x u_search_taps places of the map, in a square as wide as the kernel
    // of a blocker at u_search_from. Sum up the distances of those taps alone that are nearer than the point.
#endif
    return found > 0 ? sum / float(found) : 0.0;
}

// The share of the taps in a square around the point that is lit.
float filter_map(vec3 position_map, float side) {
#ifdef SOLUTION // 14.3
    float lit = 0.0;
    for (int i = 0; i < u_filter_taps; i++)
        for (int j = 0; j < u_filter_taps; j++) {
            vec2 place = position_map.xy + side * tap_offset(i, j, u_filter_taps);
            lit += texture(u_shadow_map, place).r < position_map.z ? 0.0 : 1.0;
        }
    return lit / float(u_filter_taps * u_filter_taps);
#else
    // TODO(14.3), second part: this is one tap. Take the mean of u_filter_taps x u_filter_taps.
    return texture(u_shadow_map, position_map.xy).r < position_map.z ? 0.0 : 1.0;
#endif
}
