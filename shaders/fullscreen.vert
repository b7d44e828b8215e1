#version 410 core
// One triangle that covers the viewport, made from the vertex number alone; v_uv is (0, 0) at the lower left
// corner of the viewport and (1, 1) at the upper right one.

out vec2 v_uv;

void main() {
    v_uv = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
    gl_Position = vec4(2.0 * v_uv - 1.0, 0.0, 1.0);
}
