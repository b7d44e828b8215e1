// Points in the hemisphere of radius 1 over a surface, denser towards its normal (cosine-weighted directions) and spread
// over all distances.

const int hemisphere_count = 24;

// The i-th point, relative to the surface.
vec3 hemisphere_point(int i, vec3 normal)
{
    vec3 right = normalize(cross(abs(normal.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), normal));
    vec3 up = cross(normal, right);
    // Evenly spread numbers: Hammersley's in the plane, multiples of the golden ratio for the distance.
    float x = (float(i) + 0.5) / float(hemisphere_count);
    float angle = 6.2831853 * float(bitfieldReverse(uint(i)) >> 8) / 16777216.0;
    float radius = mix(0.1, 1.0, fract(0.618034 * float(i) + 0.5));
    return radius * (sqrt(x) * (cos(angle) * right + sin(angle) * up) + sqrt(1.0 - x) * normal);
}
