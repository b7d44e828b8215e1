#version 410 core
// A face of a shadow volume: where the ray of this pixel enters the shadow, or where it leaves it.

#include "dust.glsl"

in vec4 v_position_world; // the point (x, y, z) / w of the face; w is 0 at infinity

out vec2 o_interval; // enters, leaves

void main() {
    vec2 uv = gl_FragCoord.xy / vec2(textureSize(u_depth, 0));
#ifdef SOLUTION // 13.8
    float way = length(v_position_world.xyz - v_position_world.w * u_eye_world) / v_position_world.w;
    float light = u_scattering * gathered(min(way, distance(u_eye_world, seen_at(uv))));
    o_interval = gl_FrontFacing ? vec2(light, 0.0) : vec2(0.0, light);
#else
    // TODO(13.8): how far is this point of the face from the eye? Take w times the eye away first and divide
    // by w last: 0 / 0 is no number. Behind what is seen at uv no dust counts: take the smaller of both
    // distances. What all dust up to there would send, u_scattering * gathered(...), goes into the first
    // number where the ray enters the volume, at a front face, and into the second where it leaves it; the
    // other one is 0. Look up: gl_FrontFacing.
    o_interval = vec2(0.0);
#endif
}
