#version 410 core
// Given: the surfaces, dimmed by the dust before them, and what this dust scatters itself.

#include "dust.glsl"

in vec2 v_uv;

uniform sampler2D u_surfaces;
uniform sampler2D u_dust;
uniform bool u_shows_distance; // for the stage "distance": white is 20 units

out vec4 o_color;

// A white surface that looks to the light sends the light's colour to all sides before it. The same light on
// a grain goes to all sides alike: a quarter of that arrives (pi / (4 pi)).
const float PHASE = 0.25;

void main() {
    float dust = texture(u_dust, v_uv).r;
    float way = distance(u_eye_world, seen_at(v_uv));
    vec3 surface = texture(u_surfaces, v_uv).rgb * transmittance(way);
    vec3 color = u_flat_light ? vec3(dust) : surface + PHASE * dust * u_lights[0].color;
    o_color = vec4(u_shows_distance ? vec3(way / 20.0) : color, 1.0);
}
