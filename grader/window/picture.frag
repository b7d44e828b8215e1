#version 410 core
// Shows a picture whose first row is the top one.

in vec2 v_uv;

uniform sampler2D u_picture;

out vec4 o_color;

void main()
{
    o_color = vec4(texture(u_picture, vec2(v_uv.x, 1.0 - v_uv.y)).rgb, 1.0);
}
