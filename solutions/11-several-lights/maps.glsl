// Given: which maps a light has, and where a point lies in them. See maps.h.

#include "lighting.glsl"

uniform sampler2DArrayShadow u_maps;    // a lookup: (x, y, layer, depth to compare with)
uniform samplerCubeArrayShadow u_cubes; // a lookup: (direction, cube) and the depth to compare with
uniform mat4 u_map_clip_from_world[64]; // for each map the matrix with which it was drawn
uniform vec4 u_maps_of_light[4];        // for each light: first map, number of maps, near plane, far plane
uniform bool u_shadows;                 // the knob
uniform bool u_show_asked;              // the stage "asked"

int first_map(int light) {
    return int(u_maps_of_light[light].x);
}

// 0 for a LIGHT_POINT, which has a cube with the light's number.
int map_count(int light) {
    return int(u_maps_of_light[light].y);
}

// True when the map says something about the point; position_map is then its place in the map (xy) and its
// depth (z), all in [0, 1]. False when it does not: then `outside` is the light that the point gets, 1
// (beyond the map's sides or its far plane) or 0 (behind the light).
bool find_in_map(int map, vec3 position_world, out vec3 position_map, out float outside) {
    vec4 position_light_clip = u_map_clip_from_world[map] * vec4(position_world, 1.0);
    outside = position_light_clip.w <= 0.0 ? 0.0 : 1.0;
    position_map = position_light_clip.xyz / position_light_clip.w * 0.5 + 0.5;
    return position_light_clip.w > 0.0 && position_map.z <= 1.0 &&
           all(greaterThanEqual(position_map.xy, vec2(0.0))) &&
           all(lessThanEqual(position_map.xy, vec2(1.0)));
}
