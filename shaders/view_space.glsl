// Back from a picture drawn with geometry.frag to view space: the camera at 0, looking along -z.

uniform sampler2D u_geometry;  // normal and distance; distance 0 where nothing was drawn
uniform mat4 u_clip_from_view; // a perspective projection

// Distance of what is seen at `uv` of the picture, along the camera's axis; 0 for nothing.
float seen_distance(vec2 uv) {
    return textureLod(u_geometry, uv, 0.0).w;
}

vec3 seen_normal_view(vec2 uv) {
    return normalize(textureLod(u_geometry, uv, 0.0).xyz);
}

vec3 seen_position_view(vec2 uv) {
    vec2 ndc = 2.0 * uv - 1.0;
    return seen_distance(uv) * vec3(ndc.x / u_clip_from_view[0][0], ndc.y / u_clip_from_view[1][1], -1.0);
}
