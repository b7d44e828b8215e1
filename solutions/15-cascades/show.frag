#version 410 core
// Given: the slices as numbers, and their maps. See show.h.

in vec2 v_uv;

uniform int u_what; // 0: borders, 1: spheres, 2: maps
uniform int u_count;
uniform vec4 u_slices[4]; // begin, end, centre and radius of the sphere
uniform float u_near, u_far, u_tangent;
uniform sampler2DArray u_maps;
uniform mat4 u_map_clip_from_world[4];
uniform vec3 u_eye_world, u_axis_world, u_to_sun_world;

out vec4 o_color;

// A row for each slice; white from its begin to its end.
vec3 show_borders() {
    int slice = int(v_uv.y * 4.0);
    float distance = u_near * pow(u_far / u_near, v_uv.x);
    return vec3(slice < u_count && distance >= u_slices[slice].x && distance <= u_slices[slice].y);
}

// From -0.5 to 2.5 times the slice's end to the right, the eye in the middle of the height: what the slice
// holds is white in the sphere, red outside of it; else the sphere is blue.
vec3 show_spheres(int slice, vec2 place) {
    vec4 numbers = u_slices[slice];
    vec2 at = numbers.y * (3.0 * place - vec2(0.5, 1.5));
    bool in_slice = at.x >= numbers.x && at.x <= numbers.y && abs(at.y) <= u_tangent * at.x;
    bool in_sphere = distance(at, vec2(numbers.z, 0.0)) <= numbers.w;
    if (in_slice)
        return in_sphere ? vec3(1.0) : vec3(0.9, 0.2, 0.1);
    return in_sphere ? vec3(0.2, 0.4, 0.7) : vec3(0.0);
}

// Dark is near to the sun, bright is far away: from one end of the sphere to the other.
vec3 show_map(int slice, vec2 place) {
    float depth = texture(u_maps, vec3(place, float(slice))).r;
    vec4 position_world = inverse(u_map_clip_from_world[slice]) * vec4(2.0 * vec3(place, depth) - 1.0, 1.0);
    vec3 centre_world = u_eye_world + u_slices[slice].z * u_axis_world;
    float beyond = dot(centre_world - position_world.xyz, u_to_sun_world) / u_slices[slice].w;
    return vec3(0.5 + 0.5 * beyond);
}

void main() {
    vec2 tile = floor(2.0 * v_uv), place = 2.0 * v_uv - tile;
    int slice = int(tile.x + 2.0 * tile.y);
    vec3 color = vec3(0.0);
    if (u_what == 0)
        color = show_borders();
    else if (slice < u_count)
        color = u_what == 1 ? show_spheres(slice, place) : show_map(slice, place);
    o_color = vec4(color, 1.0);
}
