#include "scene/scene.h"

#include "scene/check.h"

#include <math.h>

// A view is steadier the farther its up vector lies from the line of sight; nearer than this (a tangent) +y
// says nothing any more.
static const float STRAIGHT = 1e-3f;

static bool is_straight(vec3s eye, vec3s target) {
    vec3s line = glms_vec3_sub(target, eye);
    return hypotf(line.x, line.z) <= STRAIGHT * fabsf(line.y);
}

static mat4s view_from_world(vec3s eye, vec3s target) {
    return glms_lookat(eye, target, is_straight(eye, target) ? vec3_make(0, 0, -1) : vec3_make(0, 1, 0));
}

static const float LEAST_AXIS = 1e-6f; // of an object, world units

static bool object_check(const Object *object, int number) {
    mat3s axes = glms_mat4_pick3(object->world_from_object);
    for (int i = 0; i < 3; i++)
        if (!(glms_vec3_norm(axes.col[i]) >= LEAST_AXIS && glms_vec3_norm(axes.col[i]) < INFINITY))
            return check_fail(
                "object %d is flat: axis %c of its world_from_object is %g long; scale it by at "
                "least %g",
                number, "xyz"[i], (double)glms_vec3_norm(axes.col[i]), (double)LEAST_AXIS);
    return glms_mat3_det(axes) > 0 ||
           check_fail(
               "object %d is mirrored: its world_from_object turns it inside out (determinant %g); scale "
               "by positive numbers, and turn it instead",
               number, (double)glms_mat3_det(axes));
}

bool scene_check(const Scene *scene) {
    for (int i = 0; i < scene->object_count; i++)
        if (!object_check(&scene->objects[i], i))
            return false;
    return true;
}

bool light_is_overhead(const Light *light) {
    return is_straight(light->position, light->target);
}

mat4s light_view_from_overhead(const Light *light) {
    return glms_lookat(light->position, light->target, vec3_make(0, 0, -1));
}

mat4s camera_view_from_world(const Camera *camera) {
    return view_from_world(camera->eye, camera->target);
}

mat4s camera_clip_from_view(const Camera *camera, float aspect) {
    return glms_perspective(camera->fov_y, aspect, camera->near_plane, camera->far_plane);
}

void light_axes(const Light *light, vec3s *right, vec3s *up) {
    mat4s view = view_from_world(light->position, light->target);
    *right = vec3_make(view.m00, view.m10, view.m20);
    *up = vec3_make(view.m01, view.m11, view.m21);
}

bool medium_check(const Medium *medium) {
    bool sound = isfinite(medium->scattering) && isfinite(medium->extinction) && medium->scattering >= 0 &&
                 medium->extinction >= 0;
    return sound || check_fail("a medium of scattering %g and extinction %g: give both from 0 on",
                               (double)medium->scattering, (double)medium->extinction);
}
