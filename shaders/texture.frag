#version 410 core
// Shows a texture over the whole picture.

in vec2 v_uv;

uniform sampler2D u_texture;

out vec4 o_color;

void main() {
    o_color = vec4(texture(u_texture, v_uv).rgb, 1.0);
}
