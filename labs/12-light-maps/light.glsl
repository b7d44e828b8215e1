// The lamp's light at a point, and who keeps it away: for luxels, and for what moves.

#include "lighting.glsl"
#include "shadow_map.glsl"

// Irradiance: the light of lamp 0 that a surface receives there, as long as nothing is in the way. The
// visibility view wants to see shadows only, and takes 1.
vec3 irradiance(vec3 position_world, vec3 normal_world) {
    if (u_flat_light)
        return vec3(1.0);
    // TODO(12.2): E = color * cos / r^2, with the cosine of the angle between the normal and the direction to
    // the light; 0 where the surface looks away. normal_world is as long as the object's scale makes it. A
    // sun is infinitely far: without r^2. Look up: u_lights, direction_to_light in shaders/lights.glsl.
    return vec3(0.5);
}

// 1 where the lamp is seen from there, 0 where something of this map is in the way.
float map_visibility(sampler2D map, vec3 position_world) {
    vec3 position_map;
    float outside;
    bool found = find_in_shadow_map(position_world, position_map, outside);
    // TODO(12.7): lab 03's comparison. Where the point is not found in the map, return `outside`. The bias is
    // in the map already. Look up: find_in_shadow_map in shaders/shadow_map.glsl.
    return 1.0;
}
