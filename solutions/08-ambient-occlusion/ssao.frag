#version 410 core
// Ambient occlusion from the picture alone: how many points around a surface lie behind what the camera sees?

#include "hemisphere.glsl"
#include "view_space.glsl"

in vec2 v_uv;

uniform float u_radius; // world units

const float bias = 0.02; // a surface does not hide points that lie on it

out vec4 o_occlusion;

// Does something seen hide this point from the camera? `distance` is that of the
// surface that is being shaded.
bool is_hidden(vec3 point_view, float distance) {
#ifdef SOLUTION // 8.8
    vec4 point_clip = u_clip_from_view * vec4(point_view, 1.0);
    float seen = seen_distance(point_clip.xy / point_clip.w * 0.5 + 0.5);
    if (seen == 0.0 || seen >= -point_view.z - bias)
        return false;
#else
    // TODO(8.8): project the point with u_clip_from_view to find its place in the picture (as in lab 03:
    // divide by w, then from [-1, 1] to [0, 1]); `seen` is the distance seen there. What is seen does
    // not hide the point where there is nothing (`seen` is 0), nor where `seen` is not less than the point's
    // own distance, -point_view.z, minus the bias. Look up: seen_distance in shaders/view_space.glsl.
    float seen = 0.0;
    if (seen == 0.0)
        return false;
#endif
#ifdef SOLUTION // 8.9
    return distance - seen < u_radius;
#else
    // TODO(8.9): what lies more than u_radius in front of the surface is too far away to count, or a thin
    // post would darken the wall far behind it: compare `distance` with `seen`.
    return true;
#endif
}

void main() {
    float distance = seen_distance(v_uv), hidden = 0.0;
    if (distance == 0.0) {
        o_occlusion = vec4(0.0);
        return;
    }
    vec3 position_view = seen_position_view(v_uv), normal_view = seen_normal_view(v_uv);
    for (int i = 0; i < hemisphere_count; i++)
        if (is_hidden(position_view + u_radius * hemisphere_point(i, normal_view), distance))
            hidden += 1.0;
    o_occlusion = vec4(vec3(hidden / float(hemisphere_count)), 1.0);
}
