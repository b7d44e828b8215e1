#version 410 core
// The picture: baked light on what stands still, and the shadow of what moves.

#include "light.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;
in vec2 v_uv;       // the place on the face, in [0, 1] x [0, 1]
flat in int v_face; // the face's number

uniform vec4 u_charts[96]; // of each face: left, bottom, width, height of its chart, luxels; 0: it has none
uniform sampler2D u_light_map;
uniform sampler2D u_still, u_moving; // shadow maps of what stands still, and of what moves

out vec4 o_color;

// What the light map holds for this place.
vec3 baked_light() {
#ifdef SOLUTION // 12.3
    vec4 chart = u_charts[v_face];
    return texture(u_light_map, (chart.xy + v_uv * chart.zw) / vec2(textureSize(u_light_map, 0))).rgb;
#else
    // TODO(12.3): where in the light map, in luxels, does v_uv lie (lab 08)? Divide by the map's size, and
    // look it up. Look up: texture, textureSize.
    return vec3(0.5);
#endif
}

// Which share of the lamp's light is left by what moves?
float moving_visibility() {
#ifdef SOLUTION // 12.9
    return map_visibility(u_moving, v_position_world);
#else
    // TODO(12.9), second part: ask the shadow map of what moves.
    return 1.0;
#endif
}

void main() {
    bool is_baked = u_charts[v_face].z > 0.0;
    vec3 light =
        is_baked ? baked_light()
                 : irradiance(v_position_world, v_normal_world) * map_visibility(u_still, v_position_world);
    light *= moving_visibility();
    if (u_flat_light) {
        o_color = vec4(light * phong_diffuse_specular(0, v_position_world, v_normal_world), 1.0);
        return;
    }
#ifdef SOLUTION // 12.4
    o_color = vec4(u_color * (u_ambient_light + light), 1.0);
#else
    // TODO(12.4): a surface reflects, of the light that it receives, the part that its colour says. It
    // receives the ambient light (u_ambient_light) and `light`.
    o_color = vec4(u_color, 1.0);
#endif
}
