#version 410 core
// The scene with the shadow of light 0, its edge softened by percentage-closer filtering.

#include "lighting.glsl"
#include "shadow_map.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

uniform sampler2D u_depths;           // the map's depths, nearest texel
uniform sampler2DShadow u_shadow_map; // the same map; a lookup compares as task 5.2 has set it
uniform int u_method;
uniform int u_radius; // of the box, texels

// The values of u_method, as in lab.c.
const int HARD = 0, BY_HAND = 1, LINEAR = 2, DIAGONALS = 3, BOX = 4, GATHER = 5;

out vec4 o_color;

// Method 0, the answer of lab 03: one texel, all or nothing.
float hard(vec3 position_map) {
    return texture(u_depths, position_map.xy).r < position_map.z ? 0.0 : 1.0;
}

// Method 1: 3 x 3 texels, compared one by one.
float by_hand(vec3 position_map) {
#ifdef SOLUTION // 5.1
    vec2 texel = 1.0 / vec2(textureSize(u_depths, 0));
    float lit = 0.0;
    for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++)
            lit += texture(u_depths, position_map.xy + vec2(x, y) * texel).r < position_map.z ? 0.0 : 1.0;
    return lit / 9.0;
#else
    // TODO(5.1): the share of lit ones among 3 x 3 texels: compare each depth on its own, then take the mean
    // of the answers. A neighbour lies one texel away, which is 1 / (size of the map). Look up: textureSize.
    return hard(position_map);
#endif
}

// Method 2: one lookup that compares four texels and blends the answers.
float linear(vec3 position_map) {
#ifdef SOLUTION // 5.2
    return texture(u_shadow_map, position_map);
#else
    // TODO(5.2), second part: look up u_shadow_map. Look up: texture with a sampler2DShadow; what is its
    // third coordinate, and what does it return?
    return by_hand(position_map);
#endif
}

// Method 3: the mean of four such lookups, one texel away along both diagonals.
float diagonals(vec3 position_world, vec3 position_map) {
#ifdef SOLUTION // 5.3
    vec4 clip = u_light_clip_from_world * vec4(position_world, 1.0);
    vec4 projected = vec4(0.5 * clip.xyz + 0.5 * clip.w, clip.w);
    float lit = textureProjOffset(u_shadow_map, projected, ivec2(-1, -1));
    lit += textureProjOffset(u_shadow_map, projected, ivec2(1, -1));
    lit += textureProjOffset(u_shadow_map, projected, ivec2(-1, 1));
    lit += textureProjOffset(u_shadow_map, projected, ivec2(1, 1));
    return lit / 4.0;
#else
    // TODO(5.3): make homogeneous coordinates whose xyz / w lie in [0, 1]: start from
    // u_light_clip_from_world * position, where xyz / w lie in [-1, 1]. Let the lookup divide. Look up:
    // textureProjOffset.
    return linear(position_map);
#endif
}

// Method 4: the mean of (2 * u_radius + 1)^2 such lookups, one texel apart.
float box(vec3 position_world, vec3 position_map) {
#ifdef SOLUTION // 5.4
    vec2 texel = 1.0 / vec2(textureSize(u_shadow_map, 0));
    float lit = 0.0;
    for (int y = -u_radius; y <= u_radius; y++)
        for (int x = -u_radius; x <= u_radius; x++)
            lit += texture(u_shadow_map, vec3(position_map.xy + vec2(x, y) * texel, position_map.z));
    int side = 2 * u_radius + 1;
    return lit / float(side * side);
#else
    // TODO(5.4): as in 5.1, but with the lookup of 5.2 and for any u_radius.
    return diagonals(position_world, position_map);
#endif
}

// Method 5: the pixels of method 4 with u_radius = 1, from four lookups instead of nine.
float gather(vec3 position_map) {
#ifdef SOLUTION // 5.5
    vec2 size = vec2(textureSize(u_shadow_map, 0));
    vec2 place = position_map.xy * size - 0.5; // counted from the centre of texel (0, 0)
    vec2 corner = floor(place), f = place - corner;
    float lit = 0.0;
    for (int i = 0; i < 4; i++) {
        bvec2 far = bvec2(i & 1, i >> 1);
        vec4 answers = textureGather(u_shadow_map, (corner + 2.0 * vec2(far)) / size, position_map.z);
        vec2 low = mix(1.0 - f, vec2(1.0), far), high = mix(vec2(1.0), f, far);
        lit += dot(answers, vec4(low.x, high.x, high.x, low.x) * vec4(high.y, high.y, low.y, low.y));
    }
    return lit / 9.0;
#else
    // TODO(5.5): nine lookups that blend 2 x 2 texels each ask only 4 x 4 different texels. Along one axis,
    // with f the place between the two middle ones, these weigh 1 - f, 1, 1, f (thirds). textureGather asks
    // 2 x 2 texels and returns the four answers unblended: x upper left, y upper right, z lower right, w
    // lower left. Place the four lookups on corners of texels, where it is certain which four are meant.
    // Look up: textureGather, floor.
    return linear(position_map);
#endif
}

float visibility(vec3 position_world) {
    vec3 position_map;
    float outside;
    if (!find_in_shadow_map(position_world, position_map, outside))
        return outside;
    switch (u_method) {
    case BY_HAND:
        return by_hand(position_map);
    case LINEAR:
        return linear(position_map);
    case DIAGONALS:
        return diagonals(position_world, position_map);
    case BOX:
        return box(position_world, position_map);
    case GATHER:
        return gather(position_map);
    default:
        return hard(position_map);
    }
}

void main() {
    float lit = visibility(v_position_world);
    o_color = vec4(phong_ambient() + lit * phong_diffuse_specular(0, v_position_world, v_normal_world), 1.0);
}
