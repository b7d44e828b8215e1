#version 410 core
// The scene with its first light, shaded by functions that lab.c chooses at run time. Subroutine uniforms are
// to GLSL what pointers to functions are to C: u_shade lights a point, u_finish changes how that is shown.
//
// From lights.glsl: u_color, u_specular, u_shininess, u_ambient_light, u_lights[0].color, u_eye_world and
// direction_to_light(0, position_world), the unit vector to the light. A v_normal_world may have any length.

#include "lights.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

out vec4 o_color;

// TODO(1.5), in GLSL, here above u_shade: declare a second type, FinishType, of functions that take color
// and normal_world (vec3) and return a vec3; its uniform u_finish; and two functions of this type:
//   finish_plain       color as it is
//   finish_posterised  each channel rounded to the nearest quarter: floor(4 color + 1/2) / 4

// TODO(1.1): declare the subroutine type ShadeType, of functions that take position_world and normal_world
// (vec3) and return a vec3; the subroutine uniform u_shade of this type; and two functions of this type:
//   shade_ambient  ambient light times the object's colour
//   shade_diffuse  the same plus light's colour times object's colour times max(n.l, 0), with unit n and l
// Look up: subroutine, subroutine uniform, subroutine(TYPE) in front of a function.

// TODO(1.3): a third function of ShadeType, shade_phong: shade_diffuse plus light's colour times u_specular
// times max(r.v, 0) to the power of u_shininess; r is the light's ray reflected at the surface, v the unit
// vector to the eye. No highlight where n.l <= 0. Look up: pow, reflect (its first argument points where?).

// TODO(1.6): one function of both types, normal_as_color(vec3 unused, vec3 normal_world): the unit normal as
// a colour, brought from [-1, 1] to [0, 1].

void main() {
    // TODO(1.1), second part: call u_shade like a function. Until then: the object's colour without light.
    vec3 color = u_color;
    // TODO(1.5), in GLSL, second part: pass color through u_finish.
    o_color = vec4(color, 1.0);
}
