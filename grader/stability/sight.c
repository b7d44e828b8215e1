#include "stability/sight.h"

#include "scene/check.h"
#include "scene/ray.h"

#include <math.h>
#include <stdlib.h>

Scene sight_casters(const Scene *scene) {
    Scene casters = *scene;
    casters.object_count = 0;
    for (int i = 0; i < scene->object_count; i++)
        if (scene->objects[i].shape != SHAPE_PLANE)
            casters.objects[casters.object_count++] = scene->objects[i];
    return casters;
}

vec3s sight_ray(const Camera *camera, MetricsSize size, int column, int row) {
    mat4s world_from_view = glms_mat4_inv(camera_view_from_world(camera));
    float up = tanf(camera->fov_y / 2), right = up * (float)size.width / (float)size.height;
    vec3s ray = vec3_make(right * (2 * ((float)column + 0.5f) / (float)size.width - 1),
                          up * (1 - 2 * ((float)row + 0.5f) / (float)size.height), -1);
    return glms_mat4_mulv3(world_from_view, ray, 0);
}

bool sight_holds(const Scene *casters, vec3s point) {
    const Light *light = &casters->lights[0];
    bool parallel = light->kind == LIGHT_DIRECTIONAL;
    vec3s to_light = glms_vec3_sub(light->position, parallel ? light->target : point);
    return ray_hits(casters, point, glms_vec3_normalize(to_light),
                    parallel ? INFINITY : glms_vec3_norm(to_light));
}

bool sight_holds_at(const Scene *casters, vec3s ray, double depth) {
    const Light *light = &casters->lights[0];
    if (isfinite(depth))
        return sight_holds(casters, glms_vec3_add(casters->camera.eye, glms_vec3_scale(ray, (float)depth)));
    return light->kind == LIGHT_SPOT &&
           ray_hits(casters, light->position, glms_vec3_normalize(ray), INFINITY);
}

int sight_enters(const Scene *casters, vec3s from, vec3s to, int steps) {
    int enters = 0;
    bool inside = sight_holds(casters, from);
    for (int i = 1; i <= steps; i++) {
        bool before = inside;
        inside = sight_holds(casters, glms_vec3_lerp(from, to, (float)i / (float)steps));
        enters += inside && !before;
    }
    return enters;
}

static bool at_outline(const Probe *probe, const uint8_t *flags, int x, int y) {
    static const int step[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    int width = probe->truth_view.size.width, height = probe->truth_view.size.height;
    for (int i = 0; i < 4; i++) {
        int column = x + step[i][0], row = y + step[i][1];
        if (column >= 0 && column < width && row >= 0 && row < height &&
            flags[row * width + column] != flags[y * width + x])
            return true;
    }
    return false;
}

SightShare sight_share(const Probe *probe, const uint8_t *flags) {
    int width = probe->truth_view.size.width, height = probe->truth_view.size.height;
    double count = 0, set = 0, outline = 0;
    for (int i = 0; i < width * height; i++)
        if (probe->measured.mask[i]) {
            count++;
            set += flags && flags[i];
            outline += probe->truth_view.distance[i] <= 0.5f ||
                       (flags && at_outline(probe, flags, i % width, i / width));
        }
    const double pairs = outline / 2, near = 2.0 / 16;
    return (SightShare){set / count, pairs * near / count};
}

bool sight_share_at(const Probe *probe, double depth, SightShare *share) {
    const Scene casters = sight_casters(&probe->truth_view.truth.scene);
    MetricsSize size = probe->truth_view.size;
    uint8_t *flags = calloc((size_t)size.width * (size_t)size.height, 1);
    if (!flags)
        return check_fail("out of memory for a picture of flags");
    for (int i = 0; i < size.width * size.height; i++)
        flags[i] =
            sight_holds_at(&casters, sight_ray(&casters.camera, size, i % size.width, i / size.width), depth);
    *share = sight_share(probe, flags);
    free(flags);
    return true;
}
