#version 410 core
// Dilation: the padding around the charts takes the light of the charts.

uniform sampler2D u_bare; // the luxels that were baked: alpha 1; all others: 0
uniform int u_padding;    // luxels

out vec4 o_luxel;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(u_bare, 0) - 1;
    o_luxel = texelFetch(u_bare, here, 0);
    // TODO(12.5): a luxel that was not baked (alpha 0) takes the nearest one that was, at most u_padding
    // columns and rows away. Look at all of them, and keep the one with the least x * x + y * y. Stay between
    // (0, 0) and `last`.
}
