#version 410 core
// The scene; the screen in it shows u_texture.

#include "lighting.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;
in vec2 v_uv;

uniform bool u_is_screen;
uniform sampler2D u_texture;

out vec4 o_color;

void main() {
    vec3 color = phong_ambient() + phong_diffuse_specular(0, v_position_world, v_normal_world);
    if (u_is_screen) {
        // TODO(2.5): show the texture instead: look it up at v_uv. Until then the screen is magenta.
        color = vec3(1.0, 0.0, 1.0);
    }
    o_color = vec4(color, 1.0);
}
