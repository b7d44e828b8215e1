#version 410 core
// One colour everywhere.

uniform vec3 u_constant;

out vec4 o_color;

void main() {
    o_color = vec4(u_constant, 1.0);
}
