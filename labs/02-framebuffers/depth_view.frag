#version 410 core
// Full-screen view of a depth texture as distances: black at the camera, white where u_view_range is reached.

in vec2 v_uv;

uniform sampler2D u_depth_texture;
uniform float u_near; // of the camera that drew the texture
uniform float u_far;

const float u_view_range = 12.0; // world units

out vec4 o_color;

void main() {
    // TODO(2.6): read the depth at v_uv (in [0, 1]), turn it into z_ndc (in [-1, 1]), that into the
    // distance from the camera with the formula of the handout, and show distance / u_view_range as
    // grey. Until then: magenta.
    o_color = vec4(1.0, 0.0, 1.0, 1.0);
}
