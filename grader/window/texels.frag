#version 410 core
// The borders of a light's texels on what it shines on. Texels that are too small to be told apart are a
// tint.

in vec3 v_position_world;
in vec3 v_normal_world;

uniform mat4 u_map_clip_from_world;
uniform vec3 u_map_position_world;
uniform vec3 u_map_direction; // of the light's rays, where they are parallel; else 0
uniform float u_map_size;
uniform vec3 u_tint;

out vec4 o_color;

void main() {
    vec4 position_map = u_map_clip_from_world * vec4(v_position_world, 1.0);
    vec3 inside = abs(position_map.xyz);
    bool is_parallel = dot(u_map_direction, u_map_direction) > 0.0;
    vec3 to_light = is_parallel ? -u_map_direction : u_map_position_world - v_position_world;
    vec2 texel = (position_map.xy / position_map.w * 0.5 + 0.5) * u_map_size;
    vec2 step = max(fwidth(texel), 1e-6);
    vec2 away = (0.5 - abs(fract(texel) - 0.5)) / step; // pixels to the next border
    float border = 1.0 - clamp(min(away.x, away.y), 0.0, 1.0);
    float fine = smoothstep(0.25, 0.5, max(step.x, step.y));
    bool is_seen = position_map.w > 0.0 && max(inside.x, max(inside.y, inside.z)) <= position_map.w &&
                   dot(v_normal_world, to_light) > 0.0;
    o_color = vec4(u_tint, is_seen ? mix(0.75 * border, 0.2, fine) : 0.0);
}
