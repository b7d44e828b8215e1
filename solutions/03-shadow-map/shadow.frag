#version 410 core
// The scene with the shadow of light 0.

#include "lighting.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

uniform sampler2D u_shadow_map;       // depths in [0, 1] as the light sees them
uniform mat4 u_light_clip_from_world; // the matrix with which the map was drawn

out vec4 o_color;

// 1 where light 0 reaches the point, 0 in its shadow.
float visibility(vec3 position_world) {
    vec4 position_light_clip = u_light_clip_from_world * vec4(position_world, 1.0);
#ifdef SOLUTION // 3.5
    vec3 position_map = position_light_clip.xyz / position_light_clip.w * 0.5 + 0.5;
#else
    // TODO(3.5): from clip space to the map: divide by w, then bring [-1, 1] to [0, 1].
    vec3 position_map = vec3(0.0);
#endif
#ifdef SOLUTION // 3.7
    if (position_light_clip.w <= 0.0)
        return 0.0;
#else
    // TODO(3.7): a spot light shines forwards only: a point behind it (w <= 0) gets no light. Return 0.
#endif
#ifdef SOLUTION // 3.8
    if (position_map.z > 1.0)
        return 1.0;
#else
    // TODO(3.8): a point beyond the far plane of the light (z > 1) is lit: return 1.
#endif
#ifdef SOLUTION // 3.5
    float depth = texture(u_shadow_map, position_map.xy).r;
    return depth < position_map.z ? 0.0 : 1.0;
#else
    // TODO(3.5), second part: read the map's depth at position_map.xy. If it is less than position_map.z,
    // something stands between the light and this point: return 0.
    return 1.0;
#endif
}

void main() {
    vec3 ambient = phong_ambient();
    vec3 diffuse_specular = phong_diffuse_specular(0, v_position_world, v_normal_world);
#ifdef SOLUTION // 3.5
    float lit = visibility(v_position_world);
    o_color = vec4(ambient + lit * diffuse_specular, 1.0);
#else
    // TODO(3.5), third part: ask visibility(v_position_world). A shadow takes the diffuse and specular light
    // away and leaves the ambient light.
    o_color = vec4(ambient + diffuse_specular, 1.0);
#endif
}
