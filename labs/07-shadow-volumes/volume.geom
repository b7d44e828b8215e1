#version 410 core
// A triangle's part of its object's shadow volume. The volume begins at the faces that look towards the light
// and goes to infinity; all its faces are counter-clockwise seen from outside it.

#include "lighting.glsl"

layout(triangles_adjacency) in;
layout(triangle_strip, max_vertices = 18) out;

in vec3 v_position_world[]; // 0, 2, 4: the triangle, counter-clockwise; 1: far corner of its neighbour at the
                            // edge from 0 to 2; 3: at the edge from 2 to 4; 5: at the edge from 4 to 0

uniform mat4 u_clip_from_world;

// Any order of all points, the same for everybody.
bool before(vec3 a, vec3 b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

// Does the front of the triangle, counter-clockwise a, b, c, look towards the light?
bool faces_light(vec3 a, vec3 b, vec3 c) {
    // TODO(7.10): a triangle is asked about by itself and by its neighbours, each time from another first
    // corner. Where the light only grazes it, rounding then gives different answers and the volume gets
    // holes. Turn a, b, c round (a to c, b to a, c to b) until a is before(...) the others.
    // TODO(7.4): the triangle's normal is the cross product of two of its sides; it looks towards the light
    // when its dot product with the direction to the light, direction_to_light(0, a), is above 0.
    return true;
}

void emit(vec4 position_clip) {
    gl_Position = position_clip;
    EmitVertex();
}

// Where a point of the world is in the picture.
vec4 here(vec3 p) {
    return u_clip_from_world * vec4(p, 1.0);
}

// The same for the point at infinity behind it, as seen from the light.
vec4 at_infinity(vec3 p) {
    // TODO(7.5): a direction is a point with w = 0: take the direction away from the light.
    return here(p);
}

// The side of the volume at the edge from a to b of a triangle that looks towards the light.
void emit_side(vec3 a, vec3 b) {
    // TODO(7.5), second part: emit the four corners a, b and their points at infinity, as a strip whose
    // triangles are counter-clockwise seen from outside. Until then a fin marks the edge.
    emit(here(a));
    emit(here(b));
    emit(here(mix(a, b, 0.5) - 0.3 * direction_to_light(0, a)));
    EndPrimitive();
}

void emit_caps(vec3 a, vec3 b, vec3 c) {
    // TODO(7.7): close the volume: the near cap is the triangle itself, the far cap the triangle at infinity,
    // turned over (its outside is the far side).
}

#include "fins.glsl" // for the stage "fins"

void main() {
    vec3 a = v_position_world[0], b = v_position_world[2], c = v_position_world[4];
    if (!faces_light(a, b, c))
        return;
    emit_caps(a, b, c);
    if (!faces_light(a, v_position_world[1], b))
        emit_side(a, b);
    if (!faces_light(b, v_position_world[3], c))
        emit_side(b, c);
    if (!faces_light(c, v_position_world[5], a))
        emit_side(c, a);
}
