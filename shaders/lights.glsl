// The lights of a scene, the surface that they shine on, and the viewer: what shading asks for.

struct Light {
    vec3 position_world;
    vec3 target_world;
    vec3 color;
    bool is_directional;
};

uniform Light u_lights[4];
uniform int u_light_count;
uniform vec3 u_ambient_light;
uniform bool u_flat_light;
uniform vec3 u_eye_world;

uniform vec3 u_color;
uniform float u_specular;
uniform float u_shininess;

// Unit vector from the surface to light i.
vec3 direction_to_light(int i, vec3 position_world) {
    if (u_lights[i].is_directional)
        return normalize(u_lights[i].position_world - u_lights[i].target_world);
    return normalize(u_lights[i].position_world - position_world);
}
