#version 410 core
// Dilation: the padding around the charts takes the light of the charts.

uniform sampler2D u_bare; // the luxels that were baked: alpha 1; all others: 0
uniform int u_padding;    // luxels

out vec4 o_luxel;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(u_bare, 0) - 1;
    o_luxel = texelFetch(u_bare, here, 0);
#ifdef SOLUTION // 12.5
    int nearest = o_luxel.a > 0.0 ? 0 : 1000000;
    for (int y = -u_padding; y <= u_padding; y++)
        for (int x = -u_padding; x <= u_padding; x++) {
            ivec2 there = here + ivec2(x, y);
            if (x * x + y * y >= nearest || any(lessThan(there, ivec2(0))) || any(greaterThan(there, last)))
                continue;
            vec4 luxel = texelFetch(u_bare, there, 0);
            if (luxel.a > 0.0) {
                o_luxel = luxel;
                nearest = x * x + y * y;
            }
        }
#else
    // TODO(12.5): a luxel that was not baked (alpha 0) takes the nearest one that was, at most u_padding
    // columns and rows away. Look at all of them, and keep the one with the least x * x + y * y. Stay between
    // (0, 0) and `last`.
#endif
}
