// Phong's lighting (Phong: Illumination for Computer Generated Pictures, CACM 1975), split into the part that
// a shadow leaves (ambient) and the part that it takes away (diffuse and specular).
//
// The visibility view sets u_flat_light: then the ambient part is black and the other part white wherever the
// surface faces the light, so that the picture shows nothing but the shadow. Several lights share the white:
// their sum is at most 1.

#include "lights.glsl"

vec3 phong_ambient() {
    return u_flat_light ? vec3(0.0) : u_ambient_light * u_color;
}

// Light i's diffuse and specular reflection, without any shadow.
vec3 phong_diffuse_specular(int i, vec3 position_world, vec3 normal_world) {
    vec3 to_light = direction_to_light(i, position_world);
    vec3 normal = normalize(normal_world);
    float facing = dot(normal, to_light);
    if (u_flat_light)
        return vec3(facing > 0.05 ? 1.0 / float(u_light_count) : 0.0);
    if (facing <= 0.0)
        return vec3(0.0);
    vec3 to_eye = normalize(u_eye_world - position_world);
    float highlight = pow(max(dot(reflect(-to_light, normal), to_eye), 0.0), u_shininess);
    return u_lights[i].color * (u_color * facing + u_specular * highlight);
}
