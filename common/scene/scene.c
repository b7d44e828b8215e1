#include "scene/scene.h"

mat4s camera_view_from_world(const Camera *camera) {
    return glms_lookat(camera->eye, camera->target, vec3_make(0, 1, 0));
}

mat4s camera_clip_from_view(const Camera *camera, float aspect) {
    return glms_perspective(camera->fov_y, aspect, camera->near_plane, camera->far_plane);
}

void light_axes(const Light *light, vec3s *right, vec3s *up) {
    mat4s view = glms_lookat(light->position, light->target, vec3_make(0, 1, 0));
    *right = vec3_make(view.m00, view.m10, view.m20);
    *up = vec3_make(view.m01, view.m11, view.m21);
}
