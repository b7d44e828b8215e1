// Primary rays.
#include "scene/check.h"
#include "truth/embree.h"
#include "truth/primary.h"
#include "truth/tile.h"
#include "truth/truth.h"

typedef struct Look {
    const Truth *truth;
    TruthPicture *picture;
    const TruthPlace *place; // NULL: the middle
    PrimaryRays primary;
} Look;

PrimaryRays primary_rays(const Camera *camera, int width, int height) {
    mat4s view = camera_view_from_world(camera);
    mat4s clip = camera_clip_from_view(camera, (float)width / (float)height);
    vec3s right = vec3_make(view.m00, view.m10, view.m20), up = vec3_make(view.m01, view.m11, view.m21);
    return (PrimaryRays){.width = width,
                         .height = height,
                         .right = glms_vec3_divs(right, clip.m00),
                         .up = glms_vec3_divs(up, clip.m11),
                         .forward = vec3_make(-view.m02, -view.m12, -view.m22)};
}

// Where in the pixel, 0..1.
static vec2s place_in(const TruthPlace *place, uint64_t pixel) {
    if (!place)
        return (vec2s){{0.5f, 0.5f}};
    int strata = place->across * place->across;
    Random order = {place->seed + pixel * 0xd1342543de82ef95u};
    int stratum = place->part ^ (int)(random_next(&order) % (uint64_t)strata);
    Random random = {random_next(&order) + (uint64_t)place->part * 0x9fb21c651e98df25u};
    random.state = random_next(&random); // neighbouring seeds share most of their sequence
    int column = stratum % place->across, row = stratum / place->across;
    float x = (float)column + random_range(&random, 0, 1);
    float y = (float)row + random_range(&random, 0, 1);
    return glms_vec2_divs((vec2s){{x, y}}, (float)place->across);
}

vec3s primary_direction(const PrimaryRays *primary, int column, int row, vec2s within) {
    float x = ((float)column + within.x) / (float)primary->width * 2 - 1;
    float y = 1 - ((float)row + within.y) / (float)primary->height * 2;
    return glms_vec3_add(primary->forward,
                         glms_vec3_add(glms_vec3_scale(primary->right, x), glms_vec3_scale(primary->up, y)));
}

static vec3s mix(const vec3s corners[3], float u, float v) {
    return glms_vec3_add(glms_vec3_scale(corners[0], 1 - u - v),
                         glms_vec3_add(glms_vec3_scale(corners[1], u), glms_vec3_scale(corners[2], v)));
}

// From the triangle, not from the ray's length: that is exact to a rounding, however far the camera is.
static TruthHit make_hit(const Truth *truth, unsigned object, unsigned triangle, float u, float v) {
    const Mesh *mesh = &truth->meshes[truth->scene.objects[object].shape];
    mat4s world = truth->scene.objects[object].world_from_object;
    mat3s normal_from_object = glms_mat3_transpose(glms_mat3_inv(glms_mat4_pick3(world)));
    vec3s positions[3], normals[3];
    for (int i = 0; i < 3; i++) {
        const Vertex *vertex = &mesh->vertices[mesh->indices[3 * triangle + (unsigned)i]];
        positions[i] = glms_mat4_mulv3(world, vertex->position, 1);
        normals[i] = vertex->normal;
    }
    vec3s across = glms_vec3_sub(positions[1], positions[0]),
          along = glms_vec3_sub(positions[2], positions[0]);
    return (TruthHit){.object = (int32_t)object,
                      .triangle = (int32_t)triangle,
                      .position = mix(positions, u, v),
                      .face_normal = glms_vec3_normalize(glms_vec3_cross(across, along)),
                      .normal = glms_vec3_normalize(glms_mat3_mulv(normal_from_object, mix(normals, u, v)))};
}

static void look_tile(const Tile *tile, void *context) {
    const Look *look = context;
    const Camera *camera = &look->truth->scene.camera;
    struct RTCRayHit16 rays = {0};
    struct RTCIntersectArguments with;
    rtcInitIntersectArguments(&with);
    with.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    for (int i = 0; i < TILE_LANES; i++) {
        vec2s within = place_in(look->place, tile->pixel[i]);
        vec3s direction = primary_direction(&look->primary, tile->column[i], tile->row[i], within);
        rays.ray.org_x[i] = camera->eye.x, rays.ray.org_y[i] = camera->eye.y,
        rays.ray.org_z[i] = camera->eye.z;
        rays.ray.dir_x[i] = direction.x, rays.ray.dir_y[i] = direction.y, rays.ray.dir_z[i] = direction.z;
        rays.ray.tnear[i] = camera->near_plane, rays.ray.tfar[i] = camera->far_plane;
        rays.ray.mask[i] = ~0u;
        rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(tile->inside, look->truth->tree, &rays, &with);
    for (int i = 0; i < TILE_LANES; i++)
        if (tile->inside[i])
            look->picture->hits[tile->pixel[i]] =
                rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID
                    ? (TruthHit){.object = TRUTH_NONE, .triangle = TRUTH_NONE}
                    : make_hit(look->truth, rays.hit.geomID[i], rays.hit.primID[i], rays.hit.u[i],
                               rays.hit.v[i]);
}

static void look(const Truth *truth, TruthPicture *picture, const TruthPlace *place) {
    PrimaryRays primary = primary_rays(&truth->scene.camera, picture->width, picture->height);
    Look look = {truth, picture, place, primary};
    tile_each(picture->width, picture->height, look_tile, &look);
}

void truth_look(const Truth *truth, TruthPicture *picture) {
    look(truth, picture, NULL);
}

void truth_look_within(const Truth *truth, TruthPicture *picture, const TruthPlace *place) {
    INVARIANT(place->across >= 1 && place->across <= TRUTH_MAX_ACROSS &&
              !(place->across & (place->across - 1)));
    INVARIANT(place->part >= 0 && place->part < place->across * place->across);
    look(truth, picture, place);
}
