#version 410 core

out vec4 o_color;

void main() {
    o_color = vec4(sqrt(-gl_FragCoord.x), 1.0 / (gl_FragCoord.y - gl_FragCoord.y), 0.0, 1.0);
}
