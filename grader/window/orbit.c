#include "window/orbit.h"

#include <math.h>

static const float STEEPEST = 1.55F;               // radians
static const float LEAST_ZOOM = -3, MOST_ZOOM = 2; // a twentieth to seven times the distance
static const float SWING = 0.7F;                   // radians
static const double PERIOD = 8;                    // seconds

static float limited(float value, float low, float high) {
    return fminf(fmaxf(value, low), high);
}

static float elevation_of(vec3s arm) {
    return atan2f(arm.y, hypotf(arm.x, arm.z));
}

void orbit_limit(Orbit *orbit, vec3s arm) {
    float start = elevation_of(arm), limit = fmaxf(STEEPEST, fabsf(start));
    orbit->elevation = limited(orbit->elevation, -limit - start, limit - start);
    orbit->zoom = limited(orbit->zoom, LEAST_ZOOM, MOST_ZOOM);
}

// The vector from the target, turned and stretched.
static vec3s turned(vec3s arm, const Orbit *orbit) {
    float length = glms_vec3_norm(arm) * expf(orbit->zoom);
    float azimuth = atan2f(arm.x, arm.z) + orbit->azimuth, elevation = elevation_of(arm) + orbit->elevation;
    return vec3_make(length * cosf(elevation) * sinf(azimuth), length * sinf(elevation),
                     length * cosf(elevation) * cosf(azimuth));
}

static bool turns(const Orbit *orbit) {
    return orbit->azimuth != 0 || orbit->elevation != 0 || orbit->zoom != 0;
}

// Slides eye and target sideways and upwards in the picture's plane.
static void slide(Camera *camera, const Orbit *orbit) {
    vec3s arm = glms_vec3_sub(camera->eye, camera->target);
    vec3s right = glms_vec3_normalize(glms_vec3_cross(vec3_make(0, 1, 0), arm));
    vec3s up = glms_vec3_normalize(glms_vec3_cross(arm, right));
    float distance = glms_vec3_norm(arm);
    vec3s way = glms_vec3_add(glms_vec3_scale(right, orbit->right * distance),
                              glms_vec3_scale(up, orbit->up * distance));
    camera->eye = glms_vec3_add(camera->eye, way);
    camera->target = glms_vec3_add(camera->target, way);
}

void orbit_camera(Camera *camera, const Orbit *orbit) {
    if (turns(orbit))
        camera->eye =
            glms_vec3_add(camera->target, turned(glms_vec3_sub(camera->eye, camera->target), orbit));
    if (orbit->right != 0 || orbit->up != 0)
        slide(camera, orbit);
}

void orbit_light(Light *light, const Orbit *orbit) {
    Orbit turn = {.azimuth = orbit->azimuth, .elevation = orbit->elevation};
    if (turns(&turn))
        light->position =
            glms_vec3_add(light->target, turned(glms_vec3_sub(light->position, light->target), &turn));
}

Orbit orbit_swing(const Orbit *orbit, double time) {
    Orbit swung = *orbit;
    if (time != 0)
        swung.azimuth += SWING * (float)sin(time * 2 * GLM_PI / PERIOD);
    return swung;
}
