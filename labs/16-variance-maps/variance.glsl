// A shadow map that may be filtered: the mean of the depths and of their squares. Donnelly, Lauritzen:
// Variance Shadow Maps, Symposium on Interactive 3D Graphics 2006.

uniform mat4 u_light_clip_from_world;
uniform vec3 u_light_position_world, u_light_axis_world;
uniform float u_light_near, u_light_far;

// Given: the depth of a point: 0 at the light's near plane, 1 at its far plane, even between them for every
// light.
float depth_of(vec3 position_world) {
    float distance = dot(position_world - u_light_position_world, u_light_axis_world);
    return (distance - u_light_near) / (u_light_far - u_light_near);
}

// Given: is the point in the map? Then `place` is where, in [0, 1].
bool find_in_map(vec3 position_world, out vec2 place) {
    vec4 clip = u_light_clip_from_world * vec4(position_world, 1.0);
    place = clip.xy / clip.w * 0.5 + 0.5;
    return clip.w > 0.0 && all(greaterThanEqual(place, vec2(0.0))) && all(lessThanEqual(place, vec2(1.0)));
}
