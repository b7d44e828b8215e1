#version 410 core
// What the map holds of a surface: its depth, and the square of it.

#include "variance.glsl"

in vec3 v_position_world;

uniform bool u_slope; // task 16.4

out vec2 o_moments;

void main() {
    float depth = depth_of(v_position_world);
    // TODO(16.1): the first moment is there. The second one is the square of the depth.
    o_moments = vec2(depth, 0.0);
    // TODO(16.4): only if u_slope: a texel of a tilted surface holds many depths. Add a quarter of the
    // squared slope, along x and along y, to the second moment. Look up: dFdx.
}
