#version 410 core
// Shows a picture whose first row is the top one.

in vec2 v_uv;

uniform sampler2D u_picture;
uniform vec4 u_part; // of the picture: lower left corner and size, 0..1

out vec4 o_color;

void main() {
    vec2 place = u_part.xy + u_part.zw * v_uv;
    o_color = vec4(texture(u_picture, vec2(place.x, 1.0 - place.y)).rgb, 1.0);
}
