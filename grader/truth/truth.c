// Builds Embree's tree of a scene and keeps, for each pixel of a view, the point that its camera ray meets.
#include "truth/truth.h"

#include "scene/check.h"
#include "truth/embree.h"

#include <stdlib.h>
#include <string.h>

enum { RAY_DIRECTION = 4, HIT_NORMAL = 0 }; // fields of RTCRayN and RTCHitN, x, y and z in a row

// Primary rays pass through faces that are turned away, as GL_CULL_FACE has it. (Embree names the fields for
// C++ only; its manual gives their order.)
static void skip_back_faces(const struct RTCFilterFunctionNArguments *found) {
    const float *directions = (const float *)found->ray + (size_t)RAY_DIRECTION * found->N;
    const float *normals = (const float *)found->hit + (size_t)HIT_NORMAL * found->N;
    for (size_t i = 0, n = found->N; i < n; i++) {
        float facing = directions[i] * normals[i] + directions[n + i] * normals[n + i] +
                       directions[2 * n + i] * normals[2 * n + i];
        if (found->valid[i] == -1 && facing >= 0)
            found->valid[i] = 0;
    }
}

static bool fill_buffers(RTCGeometry geometry, const Mesh *mesh, mat4s world_from_object) {
    float *positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                               3 * sizeof *positions, (size_t)mesh->vertex_count);
    uint32_t *indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                3 * sizeof *indices, (size_t)mesh->index_count / 3);
    if (!positions || !indices)
        return check_fail("out of memory for the ray tracer's mesh of %d vertices", mesh->vertex_count);
    for (int i = 0; i < mesh->vertex_count; i++) {
        vec3s world = glms_mat4_mulv3(world_from_object, mesh->vertices[i].position, 1);
        memcpy(positions + (size_t)i * 3, world.raw, sizeof world.raw);
    }
    memcpy(indices, mesh->indices, (size_t)mesh->index_count * sizeof *indices);
    return true;
}

static bool attach_object(const Truth *truth, int i) {
    const Object *object = &truth->scene.objects[i];
    RTCGeometry geometry = rtcNewGeometry(truth->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    if (!geometry)
        return check_fail("Embree has no room for object %d", i);
    bool ok = fill_buffers(geometry, &truth->meshes[object->shape], object->world_from_object);
    if (ok) {
        rtcSetGeometryIntersectFilterFunction(geometry, skip_back_faces);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(truth->tree, geometry, (unsigned)i);
    }
    rtcReleaseGeometry(geometry); // the tree holds it
    return ok;
}

static bool build_tree(Truth *truth) {
    truth->device = rtcNewDevice("threads=1"); // the trees are small
    if (!truth->device)
        return check_fail("Embree does not start (error %d)", rtcGetDeviceError(NULL));
    truth->tree = rtcNewScene(truth->device);
    rtcSetSceneFlags(truth->tree, RTC_SCENE_FLAG_ROBUST); // no light through the seams of a mesh
    rtcSetSceneBuildQuality(truth->tree, RTC_BUILD_QUALITY_HIGH);
    for (int i = 0; i < truth->scene.object_count; i++)
        if (!attach_object(truth, i))
            return false;
    rtcCommitScene(truth->tree);
    enum RTCError error = rtcGetDeviceError(truth->device);
    return error == RTC_ERROR_NONE || check_fail("Embree cannot take the scene (error %d)", error);
}

bool truth_create(Truth *truth, const Scene *scene) {
    INVARIANT(scene->object_count >= 0 && scene->object_count <= SCENE_MAX_OBJECTS);
    *truth = (Truth){.scene = *scene};
    bool ok = scene_check(scene);
    for (int shape = 0; ok && shape < SHAPE_COUNT; shape++)
        ok = mesh_create(&truth->meshes[shape], (Shape)shape);
    if (ok && build_tree(truth))
        return true;
    truth_destroy(truth);
    return false;
}

void truth_destroy(Truth *truth) {
    for (int shape = 0; shape < SHAPE_COUNT; shape++)
        mesh_destroy(&truth->meshes[shape]);
    if (truth->tree)
        rtcReleaseScene(truth->tree);
    if (truth->device)
        rtcReleaseDevice(truth->device);
    *truth = (Truth){0};
}

bool truth_picture_create(TruthPicture *picture, int width, int height) {
    INVARIANT(width > 0 && height > 0);
    size_t count = (size_t)width * (size_t)height;
    *picture = (TruthPicture){.width = width, .height = height, .hits = calloc(count, sizeof *picture->hits)};
    if (!picture->hits)
        return check_fail("out of memory for the rays of %d x %d pixels", width, height);
    for (size_t i = 0; i < count; i++)
        picture->hits[i].object = picture->hits[i].triangle = TRUTH_NONE;
    return true;
}

void truth_picture_destroy(TruthPicture *picture) {
    free(picture->hits);
    *picture = (TruthPicture){0};
}

static float facing_one(const Light *light, const TruthHit *hit) {
    vec3s from = light->kind == LIGHT_DIRECTIONAL ? light->target : hit->position;
    vec3s to_light = glms_vec3_normalize(glms_vec3_sub(light->position, from));
    return fminf(glms_vec3_dot(hit->normal, to_light), glms_vec3_dot(hit->face_normal, to_light));
}

bool truth_is_wide(const Scene *scene, const TruthQuery *query) {
    if (query->kind == TRUTH_LIGHT)
        return scene->lights[query->light].extent > 0;
    bool wide = false;
    for (int i = 0; query->kind == TRUTH_LIGHTS && i < scene->light_count; i++)
        wide = wide || scene->lights[i].extent > 0;
    return wide;
}

bool truth_is_soft(const Scene *scene, const TruthQuery *query) {
    return (query->kind != TRUTH_LIGHT && query->kind != TRUTH_LIGHTS) || truth_is_wide(scene, query);
}

float truth_facing(const Scene *scene, const TruthHit *hit, int light) {
    float most = -1;
    for (int i = 0; i < scene->light_count; i++)
        if (hit->object != TRUTH_NONE && (light == TRUTH_NONE || light == i))
            most = fmaxf(most, facing_one(&scene->lights[i], hit));
    return most;
}
