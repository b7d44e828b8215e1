#version 410 core
// The mean of 2 u_radius + 1 texels in a row or in a column.

in vec2 v_uv;

uniform sampler2D u_source;
uniform vec3 u_step; // from one texel to the next, as a part of the map
uniform int u_radius;

out vec2 o_moments;

void main() {
    vec2 sum = texture(u_source, v_uv).rg;
#ifdef SOLUTION // 16.5
    sum = vec2(0.0);
    for (int i = -u_radius; i <= u_radius; i++)
        sum += texture(u_source, v_uv + float(i) * u_step.xy).rg;
    sum /= float(2 * u_radius + 1);
#else
    // TODO(16.5): this is one texel. Take the mean of those from -u_radius to u_radius.
#endif
    o_moments = sum;
}
