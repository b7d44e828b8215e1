#version 410 core
// Shows a texture over the whole picture; one channel (depth) as grey.

in vec2 v_uv;

uniform sampler2D u_texture;
uniform bool u_is_depth;

out vec4 o_color;

void main() {
    vec4 texel = texture(u_texture, v_uv);
    o_color = u_is_depth ? vec4(texel.rrr, 1.0) : vec4(texel.rgb, 1.0);
}
