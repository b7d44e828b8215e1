#include "study/fragments.h"

#include "scene/silhouette.h"

#include <math.h>

enum { MOST = 3 + 5 }; // corners of a triangle cut by five planes

// Signed distances to left, right, bottom, top and near plane in clip space.
static float distance(vec4s p, int plane) {
    return plane == 4 ? p.w + p.z : plane % 2 ? p.w - p.raw[plane / 2] : p.w + p.raw[plane / 2];
}

static int cut(const vec4s *from, int count, int plane, vec4s *to) {
    int kept = 0;
    for (int i = 0; i < count; i++) {
        vec4s here = from[i], next = from[(i + 1) % count];
        float a = distance(here, plane), b = distance(next, plane);
        if (a >= 0)
            to[kept++] = here;
        if ((a >= 0) != (b >= 0))
            to[kept++] = glms_vec4_lerp(here, next, a / (a - b));
    }
    return kept;
}

// Part of the picture that the triangle covers; its area is 4.
static double covered(const vec4s triangle[3]) {
    vec4s polygons[2][MOST] = {{triangle[0], triangle[1], triangle[2]}};
    int count = 3;
    for (int plane = 0; plane < 5 && count > 0; plane++)
        count = cut(polygons[plane % 2], count, plane, polygons[(plane + 1) % 2]);
    const vec4s *polygon = polygons[1];
    double twice = 0;
    for (int i = 0; i < count; i++) {
        vec4s a = polygon[i], b = polygon[(i + 1) % count];
        if (a.w > 0 && b.w > 0)
            twice += ((double)a.x / a.w) * ((double)b.y / b.w) - ((double)b.x / b.w) * ((double)a.y / a.w);
    }
    return fabs(twice) / 2;
}

// Adds the object's volume, in the world.
static bool add_object(Volume *volume, const Object *object, const Light *light) {
    Mesh mesh;
    Adjacency adjacency = {0};
    int first = volume->count;
    bool ok = mesh_create(&mesh, (Shape)object->shape) && adjacency_create(&adjacency, &mesh);
    if (ok && adjacency.open_edges == 0)
        ok = silhouette_add(volume, &mesh, &adjacency, object->world_from_object, light);
    for (int i = first; i < volume->count; i++)
        volume->corners[i] = glms_mat4_mulv(object->world_from_object, volume->corners[i]);
    adjacency_destroy(&adjacency);
    mesh_destroy(&mesh);
    return ok;
}

// The camera's matrix without a far plane, as volumes without an end need it.
static mat4s clip_from_world(const Camera *camera, float aspect) {
    mat4s clip_from_view = camera_clip_from_view(camera, aspect);
    clip_from_view.raw[2][2] = -1;
    clip_from_view.raw[3][2] = -2 * camera->near_plane;
    return glms_mat4_mul(clip_from_view, camera_view_from_world(camera));
}

double fragments_of_volumes(const Scene *scene, int width, int height) {
    Volume volume = {0};
    bool ok = true;
    double sum = 0;
    for (int i = 0; ok && i < scene->object_count; i++)
        ok = add_object(&volume, &scene->objects[i], &scene->lights[0]);
    mat4s clip = clip_from_world(&scene->camera, (float)width / (float)height);
    for (int i = 0; ok && i < volume.count; i += 3) {
        vec4s triangle[3];
        for (int corner = 0; corner < 3; corner++)
            triangle[corner] = glms_mat4_mulv(clip, volume.corners[i + corner]);
        sum += covered(triangle) / 4;
    }
    silhouette_destroy(&volume);
    return ok ? sum * width * height : -1;
}
