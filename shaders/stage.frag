#version 410 core
// Shows a stage's texture over the whole picture; one channel (depth) as grey, and numbers below 0, which
// would be as black as 0, in magenta.

in vec2 v_uv;

uniform sampler2D u_texture;
uniform bool u_is_depth;

out vec4 o_color;

const float NOT_ROUNDING = -0.002; // half of what one step of 8 bits is

void main() {
    vec3 texel = texture(u_texture, v_uv).rgb;
    bool negative = any(lessThan(texel, vec3(NOT_ROUNDING)));
    o_color = vec4(u_is_depth ? texel.rrr : negative ? vec3(1.0, 0.0, 1.0) : texel, 1.0);
}
