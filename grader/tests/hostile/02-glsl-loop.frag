#version 410 core

out vec4 o_color;

void main() {
    float x = gl_FragCoord.x;
    for (int i = 0; i >= 0; i++)
        x = fract(x * 3.7 + sin(x));
    o_color = vec4(x);
}
