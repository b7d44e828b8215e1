#version 410 core
// A shadow volume's corner that the CPU has placed in the world, or at infinity (w = 0).

layout(location = 0) in vec4 a_position_world;

uniform mat4 u_clip_from_world;

out vec4 v_position_world; // the point (x, y, z) / w

void main() {
    v_position_world = a_position_world;
    gl_Position = u_clip_from_world * a_position_world;
}
