#version 410 core
// What the dust before a pixel scatters to the eye, from the segments of its ray that lie in shadow.
// Distances are counted in light: what all dust up to there would send.

#include "dust.glsl"

in vec2 v_uv;

uniform sampler2DArray u_intervals; // a layer for each caster: enters, leaves; 0 and 0 where it is not met
uniform int u_count;                // of layers

out float o_dust;

vec2 interval(int caster) {
    return texelFetch(u_intervals, ivec3(gl_FragCoord.xy, caster), 0).rg;
}

// The part of a shadow's interval that lies between `from` and `to`.
float part(vec2 shadow, float from, float to) {
#ifdef SOLUTION // 13.9
    return max(min(shadow.y, to) - max(shadow.x, from), 0.0);
#else
    // TODO(13.9): how long is what both have in common? Nothing is 0, never less. Until then nothing is dark.
    return 0.0;
#endif
}

// The part between `from` and `to` that lies in any shadow.
float dark(float from, float to) {
    float sum = 0.0;
#ifdef SOLUTION // 13.10
    for (int i = 0; i < u_count; i++) {
        vec2 next = vec2(to);
        for (int caster = 0; caster < u_count; caster++) {
            vec2 shadow = interval(caster);
            if (shadow.y > from && shadow.x < next.x)
                next = shadow;
        }
        sum += part(next, from, to);
        from = next.y;
    }
#else
    // TODO(13.10): where two shadows overlap it is dark once. Of the shadows that end after `from` take the
    // one that begins first; count its part after `from`; let `from` be its end. As often as there are
    // casters. Until then each shadow counts for itself.
    for (int caster = 0; caster < u_count; caster++)
        sum += part(interval(caster), from, to);
#endif
    return sum;
}

// Given: from where to where the ray is before the light, as distances. Behind a spot light it is dark.
vec2 before_light(vec3 direction, float way) {
    vec3 axis = u_lights[0].target_world - u_lights[0].position_world;
    float height = dot(u_eye_world - u_lights[0].position_world, axis), slope = dot(direction, axis);
    float border = clamp(-height / slope, 0.0, way); // where the ray goes through the lamp's plane
    if (u_lights[0].is_directional || slope == 0.0)
        return vec2(0.0, u_lights[0].is_directional || height > 0.0 ? way : 0.0);
    return slope > 0.0 ? vec2(border, way) : vec2(0.0, border);
}

void main() {
    vec3 end_world = seen_at(v_uv);
    float way = distance(u_eye_world, end_world);
    vec2 lit = before_light((end_world - u_eye_world) / way, way);
    float from = u_scattering * gathered(lit.x), to = u_scattering * gathered(lit.y);
    o_dust = to - from - dark(from, to);
}
