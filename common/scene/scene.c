#include "scene/scene.h"

mat4s camera_view_from_world(const Camera *camera) {
    return glms_lookat(camera->eye, camera->target, vec3_make(0, 1, 0));
}

mat4s camera_clip_from_view(const Camera *camera, float aspect) {
    return glms_perspective(camera->fov_y, aspect, camera->near_plane, camera->far_plane);
}
