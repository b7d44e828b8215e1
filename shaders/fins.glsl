// The stage "fins" of lab 07. With u_fins the shader that includes this just before its main emits, in place
// of the caps and the side that main asks for, the triangle and a fin on the edge, away from the light.

uniform bool u_fins;

void emit_fin(vec3 a, vec3 b) {
    emit(here(a));
    emit(here(mix(a, b, 0.5) - 0.3 * direction_to_light(0, a)));
    emit(here(b));
    EndPrimitive();
}

void emit_triangle(vec3 a, vec3 b, vec3 c) {
    emit(here(a));
    emit(here(b));
    emit(here(c));
    EndPrimitive();
}

void emit_side_or_fin(vec3 a, vec3 b) {
    if (u_fins)
        emit_fin(a, b);
    else
        emit_side(a, b);
}

void emit_caps_or_triangle(vec3 a, vec3 b, vec3 c) {
    if (u_fins)
        emit_triangle(a, b, c);
    else
        emit_caps(a, b, c);
}

#define emit_side emit_side_or_fin
#define emit_caps emit_caps_or_triangle
