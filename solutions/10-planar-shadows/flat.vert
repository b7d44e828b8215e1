#version 410 core
// A caster's vertex, pressed flat onto the plane of a receiver, and seen by the camera.

layout(location = 0) in vec3 a_position;

uniform mat4 u_world_from_object;
uniform mat4 u_flat_from_world;
uniform mat4 u_clip_from_world;
uniform vec4 u_plane[1]; // P

out float gl_ClipDistance[1]; // what lies where it is negative is not drawn

void main() {
    vec4 position_world = u_world_from_object * vec4(a_position, 1.0);
    gl_Position = u_clip_from_world * (u_flat_from_world * position_world);
#ifdef SOLUTION // 10.5
    gl_ClipDistance[0] = dot(u_plane[0], position_world);
#else
    // TODO(10.5): what lies under the receiver throws no shadow onto it. Make the distance the height P . v,
    // so that it is negative there. (And over the lamp? See the handout.) Until then everything is drawn.
    gl_ClipDistance[0] = 1.0;
#endif
}
