// Rays from the pixels to the lights, in packets of a tile.
#include "truth/aim.h"
#include "scene/check.h"
#include "truth/dust.h"
#include "truth/embree.h"
#include "truth/tile.h"
#include "truth/truth.h"

typedef struct Trace {
    const Truth *truth;
    const TruthPicture *picture;
    const TruthQuery *query;
    float *visibility;
} Trace;

// A tile on its way; the arrays have one entry a lane.
typedef struct Packet {
    struct RTCRay16 rays;
    float frame[9][TILE_LANES];         // tangent, bitangent, face normal, world; for AIM_LOCAL only
    int alive[TILE_LANES];              // -1: a point to be lit, 0: background
    _Alignas(64) int valid[TILE_LANES]; // -1: this ray is traced, 0: it is dark without
    int lit[TILE_LANES];                // rays that met nothing
} Packet;

static void set_lane(Packet *packet, int i, const TruthHit *hit) {
    vec3s origin = aim_origin(hit);
    packet->alive[i] = hit->object == TRUTH_NONE ? 0 : -1;
    packet->rays.org_x[i] = origin.x, packet->rays.org_y[i] = origin.y, packet->rays.org_z[i] = origin.z;
    packet->rays.mask[i] = ~0u;
}

static void set_frame(Packet *packet, int i, const TruthHit *hit) {
    vec3s axes[3] = {[2] = hit->face_normal};
    aim_frame(axes[2], &axes[0], &axes[1]);
    for (int axis = 0; axis < 3; axis++)
        for (int c = 0; c < 3; c++)
            packet->frame[3 * axis + c][i] = axes[axis].raw[c];
}

static void aim_at_point(Packet *packet, const Aim *aim) {
    struct RTCRay16 *rays = &packet->rays;
    for (int i = 0; i < TILE_LANES; i++) {
        rays->dir_x[i] = aim->value.x - rays->org_x[i];
        rays->dir_y[i] = aim->value.y - rays->org_y[i];
        rays->dir_z[i] = aim->value.z - rays->org_z[i];
        float behind =
            rays->dir_x[i] * aim->front.x + rays->dir_y[i] * aim->front.y + rays->dir_z[i] * aim->front.z;
        packet->valid[i] = behind > 0 ? 0 : packet->alive[i];
    }
}

static void aim_along(Packet *packet, const Aim *aim) {
    for (int i = 0; i < TILE_LANES; i++) {
        packet->rays.dir_x[i] = aim->value.x;
        packet->rays.dir_y[i] = aim->value.y;
        packet->rays.dir_z[i] = aim->value.z;
    }
}

static void aim_in_frame(Packet *packet, const Aim *aim) {
    float x = aim->value.x, y = aim->value.y, z = aim->value.z;
    for (int i = 0; i < TILE_LANES; i++) {
        packet->rays.dir_x[i] = x * packet->frame[0][i] + y * packet->frame[3][i] + z * packet->frame[6][i];
        packet->rays.dir_y[i] = x * packet->frame[1][i] + y * packet->frame[4][i] + z * packet->frame[7][i];
        packet->rays.dir_z[i] = x * packet->frame[2][i] + y * packet->frame[5][i] + z * packet->frame[8][i];
    }
}

static void set_rays(Packet *packet, const Aim *aim) {
    for (int i = 0; i < TILE_LANES; i++) {
        packet->rays.tfar[i] = aim->limit;
        packet->valid[i] = packet->alive[i];
    }
    if (aim->kind == AIM_POINT)
        aim_at_point(packet, aim);
    else if (aim->kind == AIM_DIRECTION)
        aim_along(packet, aim);
    else
        aim_in_frame(packet, aim);
}

static void trace_singly(RTCScene tree, Packet *packet) {
    struct RTCRay16 *rays = &packet->rays;
    struct RTCOccludedArguments with;
    rtcInitOccludedArguments(&with);
    for (int i = 0; i < TILE_LANES; i++) {
        if (!packet->valid[i])
            continue;
        struct RTCRay ray = {.org_x = rays->org_x[i],
                             .org_y = rays->org_y[i],
                             .org_z = rays->org_z[i],
                             .dir_x = rays->dir_x[i],
                             .dir_y = rays->dir_y[i],
                             .dir_z = rays->dir_z[i],
                             .tfar = rays->tfar[i],
                             .mask = ~0u};
        rtcOccluded1(tree, &ray, &with);
        rays->tfar[i] = ray.tfar;
    }
}

static void trace_packet(RTCScene tree, Packet *packet) {
    struct RTCOccludedArguments with;
    rtcInitOccludedArguments(&with);
    with.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcOccluded16(packet->valid, tree, &packet->rays, &with);
}

static void trace_aims(const Trace *trace, Packet *packet, const Aim *aims, int count) {
    for (int k = 0; k < count; k++) {
        set_rays(packet, &aims[k]);
        if (trace->query->one_by_one)
            trace_singly(trace->truth->tree, packet);
        else
            trace_packet(trace->truth->tree, packet);
        for (int i = 0; i < TILE_LANES; i++) // Embree sets tfar of what is blocked to minus infinity
            packet->lit[i] += packet->rays.tfar[i] >= 0 ? packet->valid[i] & 1 : 0;
    }
}

static void trace_tile(const Tile *tile, void *context) {
    const Trace *trace = context;
    Packet packet = {0};
    Aim aims[TRUTH_MAX_SAMPLES];
    bool any = false;
    for (int i = 0; i < TILE_LANES; i++)
        if (tile->inside[i]) {
            const TruthHit *hit = &trace->picture->hits[tile->pixel[i]];
            set_lane(&packet, i, hit);
            if (trace->query->kind == TRUTH_OCCLUSION)
                set_frame(&packet, i, hit);
            any = any || packet.alive[i];
        }
    int count = any ? aim_all(&trace->truth->scene, trace->query, tile->index, aims) : 0;
    trace_aims(trace, &packet, aims, count);
    for (int i = 0; i < TILE_LANES; i++)
        if (tile->inside[i])
            trace->visibility[tile->pixel[i]] = count ? (float)packet.lit[i] / (float)count : 0;
}

static bool check_lights(const Scene *scene, const TruthQuery *query) {
    if (query->kind == TRUTH_LIGHT || query->kind == TRUTH_DUST)
        return (query->light >= 0 && query->light < scene->light_count) ||
               check_fail("the scene has no light %d; it has %d", query->light, scene->light_count);
    return query->kind != TRUTH_LIGHTS || scene->light_count > 0 || check_fail("the scene has no light");
}

static bool check_query(const Scene *scene, const TruthQuery *query) {
    if (!check_lights(scene, query))
        return false;
    if (query->kind == TRUTH_DUST)
        return medium_check(&scene->medium);
    bool lights = query->kind == TRUTH_LIGHT || query->kind == TRUTH_LIGHTS;
    if (lights && !truth_is_wide(scene, query))
        return true;
    int most = TRUTH_MAX_SAMPLES / (query->kind == TRUTH_LIGHTS ? scene->light_count : 1);
    return (query->samples >= 1 && query->samples <= most) ||
           check_fail("%d samples a pixel: take 1 to %d", query->samples, most);
}

bool truth_trace(const Truth *truth, const TruthPicture *picture, const TruthQuery *query,
                 float *visibility) {
    if (!check_query(&truth->scene, query))
        return false;
    if (query->kind == TRUTH_DUST) {
        dust_trace(truth, picture, query->light, visibility);
        return true;
    }
    Trace trace = {.truth = truth, .picture = picture, .query = query, .visibility = visibility};
    tile_each(picture->width, picture->height, trace_tile, &trace);
    return true;
}
