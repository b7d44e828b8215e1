// Points in the hemisphere of radius 1 over a surface, denser towards its normal (cosine-weighted directions)
// and spread over all distances.

const int hemisphere_count = 16;

// Hammersley's points as directions, at distances by multiples of the golden ratio; z along the normal.
const vec3 hemisphere_points[hemisphere_count] =
    vec3[](vec3(0.097, 0.000, 0.541), vec3(-0.063, 0.000, 0.196), vec3(0.000, 0.301, 0.700),
           vec3(-0.000, -0.196, 0.370), vec3(0.366, 0.366, 0.827), vec3(-0.262, -0.262, 0.511),
           vec3(-0.130, 0.130, 0.221), vec3(0.408, -0.408, 0.615), vec3(0.337, 0.139, 0.342),
           vec3(-0.111, -0.046, 0.099), vec3(-0.221, 0.533, 0.418), vec3(0.120, -0.289, 0.195),
           vec3(0.313, 0.755, 0.433), vec3(-0.204, -0.493, 0.230), vec3(-0.209, 0.086, 0.073),
           vec3(0.722, -0.299, 0.140));

// The i-th point, relative to the surface.
vec3 hemisphere_point(int i, vec3 normal) {
    vec3 right = normalize(cross(abs(normal.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), normal));
    return mat3(right, cross(normal, right), normal) * hemisphere_points[i];
}
