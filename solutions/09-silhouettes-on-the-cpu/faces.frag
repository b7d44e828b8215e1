#version 410 core
// Given: red for triangles that look to the eye, blue for the others.

out vec4 o_color;

void main() {
    o_color = gl_FrontFacing ? vec4(0.25, 0.1, 0.0, 1.0) : vec4(0.0, 0.1, 0.25, 1.0);
}
