#include "stability/tilted.h"

static const double distance = 10, fov_x = 40;

Scene tilted_wall(double theta, double psi, float half_size, double aspect) {
    double t = closed_radians(theta), a = sin(t) * cos(closed_radians(psi));
    double x = a * cos(t) / sqrt(1 - a * a), y = sqrt(fmax(sin(t) * sin(t) - x * x, 0));
    Scene scene = closed_wall(6, (float)distance, (float)(2 * atan(tan(closed_radians(fov_x / 2)) / aspect)));
    vec3s light = vec3_make((float)(-distance * x), (float)(-distance * y), (float)(distance * cos(t)));
    closed_light(&scene, LIGHT_DIRECTIONAL, light, vec3_make(0, 0, 0), 0, half_size, TILTED_NEAR, TILTED_FAR);
    return scene;
}

double tilted_slope(const Scene *scene) {
    const Light *light = &scene->lights[0];
    mat4s view = light_is_overhead(light) ? light_view_from_overhead(light)
                                          : glms_lookat(light->position, light->target, vec3_make(0, 1, 0));
    vec3s normal = glms_mat4_mulv3(view, vec3_make(0, 0, 1), 0);
    return (fabsf(normal.x) + fabsf(normal.y)) / fabsf(normal.z);
}

// Area of the part of [-1/2, 1/2]^2 where a x + b y > c, for a >= b >= 0.
double tilted_acne(double r, double psi) {
    double c = fabs(cos(closed_radians(psi))), s = fabs(sin(closed_radians(psi)));
    double a = fmax(c, s), b = fmin(c, s), level = r * (a + b) / 2;
    if (level >= (a + b) / 2)
        return 0;
    if (level <= (a - b) / 2)
        return 0.5 - level / a;
    return ((a + b) / 2 - level) * ((a + b) / 2 - level) / (2 * a * b);
}
