#version 410 core
// The scene with the sun's shadow, from the map of the slice in which a point lies.

#include "cascades.glsl"

in vec3 v_position_world;
in vec3 v_normal_world;

out vec4 o_color;

// How far before the eye a point is, along the camera's axis.
float view_depth(vec3 position_world) {
#ifdef SOLUTION // 15.5
    return dot(position_world - u_eye_world, u_axis_world);
#else
    // TODO(15.5): this is the distance to the eye, and borders are spheres. Slices end at planes: only the
    // part along the camera's axis counts. Look up: dot.
    return distance(position_world, u_eye_world);
#endif
}

// The first slice that ends behind this depth; the last one, if none does.
int slice_at(float depth) {
#ifdef SOLUTION // 15.5
    int slice = 0;
    while (slice < u_count - 1 && depth > u_ends[slice])
        slice++;
    return slice;
#else
    // TODO(15.5), second part: this is always the first slice. Look for the right one in u_ends.
    return 0;
#endif
}

// 1 where the slice's map sees the point, 0 where something stands before it.
float ask_map(int slice, vec3 position_world, vec3 normal) {
#ifdef SOLUTION // 15.8
    vec3 moved = position_world + u_offset * u_texels[slice] * normal;
#else
    // TODO(15.8): this offset is that of the first map. How large are the texels of this one?
    vec3 moved = position_world + u_offset * u_texels[0] * normal;
#endif
    vec3 position_map;
    if (!find_in_map(slice, moved, position_map))
        return 1.0;
#ifdef SOLUTION // 15.6
    return texture(u_maps, vec3(position_map.xy, float(slice))).r < position_map.z ? 0.0 : 1.0;
#else
    // TODO(15.6): read the depth in the slice's layer of u_maps; if it is less than that of the point, return
    // 0. Look up: texture of a sampler2DArray.
    return 1.0;
#endif
}

// How much of the next slice's answer counts: 0 up to where the blend begins, 1 where the slice ends.
float share_of_next(int slice, float depth) {
#ifdef SOLUTION // 15.9
    if (slice == u_count - 1 || u_blend <= 0.0)
        return 0.0;
    float begin = slice == 0 ? u_near : u_ends[slice - 1];
    return max(1.0 - (u_ends[slice] - depth) / (u_blend * (u_ends[slice] - begin)), 0.0);
#else
    // TODO(15.9), second part: grow evenly over the last u_blend of the slice's length. The last slice has
    // no next one.
    return 0.0;
#endif
}

void main() {
    float depth = view_depth(v_position_world);
    int slice = slice_at(depth);
    float next = share_of_next(slice, depth);
    vec3 normal = normalize(v_normal_world);
    float lit = ask_map(slice, v_position_world, normal);
    vec3 color = slice_color(slice);
    if (next > 0.0) {
        lit = mix(lit, ask_map(slice + 1, v_position_world, normal), next);
        color = mix(color, slice_color(slice + 1), next);
    }
    vec3 shaded = phong_ambient() + lit * phong_diffuse_specular(0, v_position_world, v_normal_world);
    o_color = vec4(u_show_slices ? color : shaded, 1.0);
}
