#version 410 core
// The scene under its ambient light, as far as that reaches, and light 0 without a shadow.

#include "lighting.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;
in vec2 v_uv;       // the place on the face, in [0, 1] x [0, 1]
flat in int v_face; // the face's number

uniform sampler2D u_baked;  // the atlas: red is the occlusion
uniform vec4 u_charts[96];  // of each face: left, bottom, width, height of its chart, texels; 0: it has none
uniform sampler2D u_screen; // red is the occlusion of the pixel
uniform bool u_use_screen;

out vec4 o_color;

// 1 where the whole sky is seen, 0 where nothing of it is.
float baked_visibility() {
    vec4 chart = u_charts[v_face];
    if (chart.z == 0.0)
        return 1.0;
    // TODO(8.3): where in the atlas, counted in texels, does v_uv lie: v_uv = (0, 0) is the chart's lower
    // left corner, (1, 1) its upper right one. Divide by the atlas's size and look the occlusion up; return
    // what it leaves. Look up: texture, textureSize.
    return 1.0;
}

void main() {
    float visibility =
        u_use_screen ? 1.0 - texelFetch(u_screen, ivec2(gl_FragCoord.xy), 0).r : baked_visibility();
    if (u_flat_light) {
        o_color = vec4(vec3(visibility), 1.0);
        return;
    }
    vec3 ambient = phong_ambient();
    vec3 diffuse_specular = phong_diffuse_specular(0, v_position_world, v_normal_world);
    // TODO(8.4): only the ambient light comes from the sky: dim it, and nothing else, by the visibility.
    o_color = vec4(ambient + diffuse_specular, 1.0);
}
