#version 410 core
// A lit surface with its shadow from the map of light 0. The point that is asked is lifted a little off its
// surface.

#include "lighting.glsl"
#include "shadow_map.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

uniform sampler2D u_shadow_map;

out vec4 o_color;

float visibility(vec3 position_world) {
    vec3 position_map;
    float outside;
    if (!find_in_shadow_map(position_world, position_map, outside))
        return outside;
    return position_map.z <= texture(u_shadow_map, position_map.xy).r ? 1.0 : 0.0;
}

void main() {
    float lit = visibility(v_position_world + 0.03 * normalize(v_normal_world));
    vec3 light = phong_diffuse_specular(0, v_position_world, v_normal_world);
    o_color = vec4(phong_ambient() + lit * light, 1.0);
}
