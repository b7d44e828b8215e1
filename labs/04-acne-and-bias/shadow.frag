#version 410 core
// The scene with the shadow of light 0, kept free of acne by the method of the knob.

#include "lighting.glsl"
#include "shadow_map.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

uniform sampler2D u_shadow_map; // depths in [0, 1] as the light sees them
uniform int u_method;
uniform float u_bias;          // depth
uniform float u_slope_bias;    // depth
uniform float u_normal_offset; // texels
uniform float u_texel_size;    // of the map, world units where the light's clip w is 1

// The values of u_method, as in lab.c.
const int CONSTANT = 1, SLOPE = 2, NORMAL_OFFSET = 5;
const int NONE = 0, POLYGON_OFFSET = 3, FRONT_FACES = 4; // of these the shader has nothing to do
// Where light falls along the normal there is no slope to offset, and rounding alone decides: a little more.
const float ROUNDING = 1e-6; // depth

out vec4 o_color;

// How much nearer to the light a point counts than it is. Both vectors are unit vectors.
float depth_bias(vec3 normal_world, vec3 to_light_world) {
    if (u_method == CONSTANT) {
        // TODO(4.1): the same bias for all: u_bias.
        return 0.0;
    }
    if (u_method == SLOPE) {
        // TODO(4.2): u_slope_bias * (1 - N.L), with N and L the two vectors, but at least
        // u_bias. Look up: dot, max.
        return 0.0;
    }
    return u_method == NORMAL_OFFSET ? ROUNDING : 0.0;
}

// The point that is looked up in the map for a point of a surface. Both directions are unit vectors.
vec3 lookup_position(vec3 position_world, vec3 normal_world, vec3 to_light_world) {
    if (u_method == NORMAL_OFFSET) {
        // TODO(4.5), second part: go along the normal by u_normal_offset texels times the sine of the
        // angle between normal and light. A texel is u_texel_size * w wide, where w is the fourth clip
        // coordinate of the point as the light sees it: 1 for a directional light, the distance from
        // the lamp for a spot light.
        return position_world;
    }
    return position_world;
}

// 1 where light 0 reaches the point, 0 in its shadow.
float visibility(vec3 position_world, vec3 normal_world) {
    vec3 position_map, to_light_world = direction_to_light(0, position_world);
    float outside;
    if (!find_in_shadow_map(lookup_position(position_world, normal_world, to_light_world), position_map,
                            outside))
        return outside;
    float depth = texture(u_shadow_map, position_map.xy).r;
    float bias = depth_bias(normal_world, to_light_world);
    // TODO(4.1), second part: compare as if the point were nearer to the light by the bias.
    return depth < position_map.z ? 0.0 : 1.0;
}

void main() {
    vec3 diffuse_specular = phong_diffuse_specular(0, v_position_world, v_normal_world);
    o_color = vec4(
        phong_ambient() + visibility(v_position_world, normalize(v_normal_world)) * diffuse_specular, 1.0);
}
