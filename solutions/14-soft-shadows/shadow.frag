#version 410 core
// The scene with the shadow of light 0, which is a square lamp.

#include "lighting.glsl"
#include "pcss.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

out vec4 o_color;

// The share of light 0 that reaches the point.
float visibility(vec3 position_world) {
    vec3 position_map;
    float outside, side = u_fixed_side;
    if (!find_in_shadow_map(position_world, position_map, outside)) {
        return outside;
    }
#ifdef SOLUTION // 14.5
    if (!u_fixed) {
        float receiver = distance_of(position_world);
        float blocker = mean_blocker(position_map, receiver);
        if (blocker == 0.0)
            return 1.0;
        side = kernel_side(blocker, receiver);
    }
#else
    // TODO(14.5): unless u_fixed, the side is that of the kernel for the mean blocker; where there is
    // none, the point is lit.
#endif
#ifdef SOLUTION // 14.6
    side = max(side, 1.0 / float(textureSize(u_shadow_map, 0).x));
#else
    // TODO(14.6): a kernel narrower than a texel shows the texel's corners: take no side less than that
    // of one texel.
#endif
    return filter_map(position_map, side);
}

void main() {
    float lit = visibility(v_position_world);
    o_color = vec4(phong_ambient() + lit * phong_diffuse_specular(0, v_position_world, v_normal_world), 1.0);
}
