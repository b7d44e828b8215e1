// Where a point lies in the shadow map of light 0: what lab 03 writes by hand, for the labs after it.

uniform mat4 u_light_clip_from_world; // the matrix with which the map was drawn

// True when the map says something about the point; position_map is then its place in the map (xy) and its
// depth (z), all in [0, 1]. False when it does not: then `outside` is the light that the point gets, 1
// (beyond the map's sides or its far plane) or 0 (behind the light).
bool find_in_shadow_map(vec3 position_world, out vec3 position_map, out float outside) {
    vec4 position_light_clip = u_light_clip_from_world * vec4(position_world, 1.0);
    outside = position_light_clip.w <= 0.0 ? 0.0 : 1.0;
    position_map = position_light_clip.xyz / position_light_clip.w * 0.5 + 0.5;
    return position_light_clip.w > 0.0 && position_map.z <= 1.0 &&
           all(greaterThanEqual(position_map.xy, vec2(0.0))) &&
           all(lessThanEqual(position_map.xy, vec2(1.0)));
}
