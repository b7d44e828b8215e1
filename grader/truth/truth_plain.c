#include "truth/truth_plain.h"

#include "truth/aim.h"
#include "truth/embree.h"
#include "truth/tile.h"

typedef struct Plain {
    const Truth *truth;
    const TruthPicture *picture;
    const TruthQuery *query;
    float *visibility;
} Plain;

typedef struct ShadedPoint {
    vec3s origin, tangent, bitangent, normal; // world
} ShadedPoint;

static ShadedPoint make_point(const TruthHit *hit) {
    ShadedPoint point = {.origin = aim_origin(hit), .normal = hit->face_normal};
    aim_frame(point.normal, &point.tangent, &point.bitangent);
    return point;
}

static vec3s direction_of(const ShadedPoint *point, const Aim *aim) {
    if (aim->kind == AIM_POINT)
        return glms_vec3_sub(aim->value, point->origin);
    if (aim->kind == AIM_DIRECTION)
        return aim->value;
    return glms_vec3_add(glms_vec3_scale(point->tangent, aim->value.x),
                         glms_vec3_add(glms_vec3_scale(point->bitangent, aim->value.y),
                                       glms_vec3_scale(point->normal, aim->value.z)));
}

static bool reaches(RTCScene tree, const ShadedPoint *point, const Aim *aim) {
    vec3s direction = direction_of(point, aim);
    if (aim->kind == AIM_POINT && glms_vec3_dot(direction, aim->front) > 0)
        return false;
    struct RTCRay ray = {.org_x = point->origin.x,
                         .org_y = point->origin.y,
                         .org_z = point->origin.z,
                         .dir_x = direction.x,
                         .dir_y = direction.y,
                         .dir_z = direction.z,
                         .tfar = aim->limit,
                         .mask = ~0u};
    struct RTCOccludedArguments with;
    rtcInitOccludedArguments(&with); // flags: incoherent
    rtcOccluded1(tree, &ray, &with);
    return ray.tfar >= 0;
}

static void trace_row(int row, void *context) {
    const Plain *plain = context;
    Aim aims[TRUTH_MAX_SAMPLES];
    for (int i = row * plain->picture->width; i < (row + 1) * plain->picture->width; i++) {
        const TruthHit *hit = &plain->picture->hits[i];
        ShadedPoint point = make_point(hit);
        int lit = 0;
        int count = hit->object == TRUTH_NONE ? 0 : aim_all(&plain->truth->scene, plain->query, i, aims);
        for (int k = 0; k < count; k++)
            lit += reaches(plain->truth->tree, &point, &aims[k]);
        plain->visibility[i] = count ? (float)lit / (float)count : 0;
    }
}

void truth_trace_plainly(const Truth *truth, const TruthPicture *picture, const TruthQuery *query,
                         float *visibility) {
    Plain plain = {truth, picture, query, visibility};
    tile_each_row(picture->height, trace_row, &plain);
}
