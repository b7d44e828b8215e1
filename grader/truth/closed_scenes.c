#include "truth/closed_scenes.h"

Scene closed_wall(float half_size, float distance, float fov_y) {
    Scene scene = {
        .camera = {
            .eye = vec3_make(0, 0, distance), .fov_y = fov_y, .near_plane = 0.5f, .far_plane = 2 * distance}};
    scene.second_camera = scene.camera;
    closed_add(&scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(half_size, 1, half_size), 0);
    scene.objects[0].world_from_object =
        glms_mat4_mul(glms_rotate_make(glm_rad(90), vec3_make(1, 0, 0)), scene.objects[0].world_from_object);
    return scene;
}

double closed_radians(double degrees) {
    return degrees * GLM_PI / 180;
}

double closed_unit(const Scene *scene, int height) {
    return 2 * scene->camera.eye.z * tan(0.5 * scene->camera.fov_y) / height;
}

void closed_add(Scene *scene, Shape shape, vec3s center, vec3s half_size, float turn) {
    mat4s placed = glms_rotate(glms_translate_make(center), glm_rad(turn), vec3_make(0, 1, 0));
    scene->objects[scene->object_count++] = (Object){.shape = (int32_t)shape,
                                                     .world_from_object = glms_scale(placed, half_size),
                                                     .color = vec3_make(1, 1, 1),
                                                     .shininess = 1};
}

void closed_light(Scene *scene, LightKind kind, vec3s position, vec3s target, float fov_y, float half_size,
                  float near_plane, float far_plane) {
    scene->lights[scene->light_count++] = (Light){.kind = (int32_t)kind,
                                                  .position = position,
                                                  .target = target,
                                                  .color = vec3_make(1, 1, 1),
                                                  .fov_y = fov_y,
                                                  .half_size = half_size,
                                                  .near_plane = near_plane,
                                                  .far_plane = far_plane};
}

Scene closed_wall_and_box(vec3s to_light, vec3s center, vec3s half_size) {
    Scene scene = closed_wall(6, 10, glm_rad(40));
    closed_add(&scene, SHAPE_BOX, center, half_size, 0);
    closed_light(&scene, LIGHT_DIRECTIONAL, to_light, vec3_make(0, 0, 0), 0, 10, 1, 20);
    return scene;
}

void closed_stand(Scene *scene, vec3s middle, float half_width, float half_height, float turn) {
    closed_add(scene, SHAPE_PLANE, middle, vec3_make(1, 1, 1), turn);
    mat4s *placed = &scene->objects[scene->object_count - 1].world_from_object;
    *placed = glms_rotate(*placed, glm_rad(90), vec3_make(1, 0, 0));
    *placed = glms_scale(*placed, vec3_make(half_width, 1, half_height));
}

enum { LAMP_ASIDE = 5 };
static const double lamp_field = 84; // of its map, degrees

Scene closed_wall_and_lamp(int width, int height) {
    Scene scene = closed_wall(6, 10, 2 * atanf(3.2F / 20 * (float)height / (float)width));
    closed_light(&scene, LIGHT_SPOT, vec3_make(-LAMP_ASIDE, 0, CLOSED_LAMP_AT), vec3_make(-LAMP_ASIDE, 0, 0),
                 glm_rad((float)lamp_field), 0, 2, 12);
    return scene;
}

void closed_plate(Scene *scene, double h, double end) {
    double edge = (end + LAMP_ASIDE) * (CLOSED_LAMP_AT - h) / CLOSED_LAMP_AT - LAMP_ASIDE;
    closed_add(scene, SHAPE_BOX, vec3_make((float)edge - 1, 0, (float)h), vec3_make(1, 2, 1e-4F), 0);
}

double closed_lamp_texel(int size) {
    return 2 * CLOSED_LAMP_AT * tan(closed_radians(lamp_field) / 2) / size;
}

double closed_beside_wall(double x, double h) {
    return (1 - x / sqrt(x * x + h * h)) / 2;
}
