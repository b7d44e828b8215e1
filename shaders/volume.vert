#version 410 core
// A shadow volume's corner that the CPU has placed in the world, or at infinity (w = 0).

layout(location = 0) in vec4 a_position_world;

uniform mat4 u_clip_from_world;

void main() {
    gl_Position = u_clip_from_world * a_position_world;
}
