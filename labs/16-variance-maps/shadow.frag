#version 410 core
// The scene with the shadow of light 0, from moments.

#include "lighting.glsl"
#include "variance.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

uniform sampler2D u_moments;
uniform float u_least_variance;
uniform float u_cut;

out vec4 o_color;

// The least variance that is believed: below it, it is noise of the numbers.
float variance_of(vec2 moments) {
    float variance = moments.y - moments.x * moments.x;
    // TODO(16.7): the knob says how small a variance may be, not this number.
    return max(variance, 0.00001);
}

// At most this share of the depths in the filter is as far as `depth` or farther.
float share_behind(vec2 moments, float depth) {
    // TODO(16.3): this is the plain map's answer, with a hard border. Beyond the mean take Chebyshev's bound,
    // which stands in the handout.
    return depth <= moments.x + 0.004 ? 1.0 : 0.0;
}

// Takes away what lies below u_cut, and stretches the rest over 0 to 1.
float cut(float share) {
    // TODO(16.8): u_cut becomes 0, 1 stays 1, and it is even between them.
    return share;
}

void main() {
    vec2 place;
    bool in_map = find_in_map(v_position_world, place);
    vec2 moments = texture(u_moments, place).rg; // for all pixels: mipmaps need their neighbours' places
    float lit = in_map ? cut(share_behind(moments, depth_of(v_position_world))) : 1.0;
    o_color = vec4(phong_ambient() + lit * phong_diffuse_specular(0, v_position_world, v_normal_world), 1.0);
}
