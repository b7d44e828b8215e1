#version 410 core
// A shadow volume's corner that the CPU has placed in an object's space, or at infinity (w = 0).

layout(location = 0) in vec4 a_position;

uniform mat4 u_world_from_object;
uniform mat4 u_clip_from_world;

out vec4 v_position_world; // the point (x, y, z) / w

void main() {
    v_position_world = u_world_from_object * a_position;
    gl_Position = u_clip_from_world * v_position_world;
}
