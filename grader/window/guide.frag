#version 410 core
// One colour, as much of it as u_share says.

uniform vec3 u_tint;
uniform float u_share;

out vec4 o_color;

void main() {
    o_color = vec4(u_tint, u_share);
}
