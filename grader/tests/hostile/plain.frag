#version 410 core

out vec4 o_color;

void main() {
    o_color = vec4(0.2, 0.4, 0.6, 1.0);
}
