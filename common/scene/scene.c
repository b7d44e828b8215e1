#include "scene/scene.h"

mat4s camera_view_from_world(const Camera *camera) {
    return glms_lookat(camera->eye, camera->target, vec3_make(0, 1, 0));
}

mat4s camera_clip_from_view(const Camera *camera, float aspect) {
    return glms_perspective(camera->fov_y, aspect, camera->near_plane, camera->far_plane);
}

mat4s scene_light_clip_from_world(const Light *light) {
    float r = light->half_size;
    mat4s clip_from_light = light->kind == LIGHT_SPOT
                                ? glms_perspective(light->fov_y, 1, light->near_plane, light->far_plane)
                                : glms_ortho(-r, r, -r, r, light->near_plane, light->far_plane);
    return glms_mat4_mul(clip_from_light, glms_lookat(light->position, light->target, vec3_make(0, 1, 0)));
}
