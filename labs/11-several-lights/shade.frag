#version 410 core
// The scene with all its lights and their shadows.

#include "maps.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

out vec4 o_color;

int asked = 0; // how many maps this point asked

// 1 where the map sees the point, 0 where something stands before it, between where four texels disagree.
float ask_map(int map, vec3 position_world) {
    vec3 position_map;
    float outside;
    if (!find_in_map(map, position_world, position_map, outside))
        return outside;
    asked++;
    // TODO(11.4): ask u_maps at this place, in this map's layer. Look up: texture of a sampler2DArrayShadow.
    return 1.0;
}

// The depth in [0, 1] of a point that lies from_lamp away from a lamp, in the face of the cube that sees it.
float cube_depth(vec3 from_lamp, float near, float far) {
    // TODO(11.6): the face that sees the point looks along the axis on which the point is farthest away.
    // What that face's projection makes of the distance stands in the handout; from [-1, 1] to [0, 1].
    return 0.0;
}

// The same for the cube of a LIGHT_POINT.
float ask_cube(int light, vec3 position_world) {
    float near = u_maps_of_light[light].z, far = u_maps_of_light[light].w;
    asked++;
    // TODO(11.6), second part: ask u_cubes in the direction from the lamp to the point, with cube_depth. Look
    // up: u_lights in shaders/lights.glsl; texture of a samplerCubeArrayShadow, which takes the depth as an
    // argument of its own.
    return 1.0;
}

// The share of the light that reaches the point.
float visibility(int light, vec3 position_world) {
    if (!u_shadows)
        return 1.0;
    if (map_count(light) == 0)
        return ask_cube(light, position_world);
    // TODO(11.8): a wide light has map_count(light) maps from first_map(light) on: take the mean of all.
    return ask_map(first_map(light), position_world);
}

// What one light adds to the point's colour.
vec3 light_from(int light, vec3 position_world, vec3 normal_world) {
    vec3 unshadowed = phong_diffuse_specular(light, position_world, normal_world);
    // TODO(11.9): where the light brings nothing, because the surface looks away from it, leave at once: no
    // map needs to be asked.
    return visibility(light, position_world) * unshadowed;
}

void main() {
    // TODO(11.3): this is one light. Add what all u_light_count lights bring.
    vec3 color = phong_ambient() + light_from(0, v_position_world, v_normal_world);
    o_color = vec4(u_show_asked ? vec3(float(asked) / 8.0) : color, 1.0);
}
