#version 410 core
// Which triangle this is, in numbers that 8 bits a channel hold exactly.

uniform int u_object; // number in the scene

out vec4 o_color;

void main() {
    o_color = vec4(u_object + 1, gl_PrimitiveID & 255, gl_PrimitiveID >> 8, 255) / 255.0;
}
