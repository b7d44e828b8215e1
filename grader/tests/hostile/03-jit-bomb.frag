#version 410 core
#define A x = sin(x) * cos(x.yzwx) + sqrt(abs(x));
#define B A A A A
#define C B B B B
#define D C C C C
#define E D D D D
#define F E E E E
#define G F F F F
#define H G G G G

out vec4 o_color;

void main() {
    vec4 x = gl_FragCoord;
    H
    o_color = x;
}
