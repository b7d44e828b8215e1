// Fills a grid of strata with one random place each, and turns places into points of lamps and directions.
#include "truth/aim.h"

void aim_frame(vec3s n, vec3s *tangent, vec3s *bitangent) {
    float sign = copysignf(1, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
    *tangent = vec3_make(1 + sign * n.x * n.x * a, sign * b, -sign * n.x);
    *bitangent = vec3_make(b, sign + n.y * n.y * a, -n.y);
}

vec3s aim_origin(const TruthHit *hit) {
    vec3s p = hit->position;
    float size = 1; // not by fmaxf: that is a call, here for each pixel
    for (int c = 0; c < 3; c++)
        size = fabsf(p.raw[c]) > size ? fabsf(p.raw[c]) : size;
    return glms_vec3_add(p, glms_vec3_scale(hit->face_normal, size * 0x1p-19f));
}

// The unit square to the unit disc, areas and, as well as can be, shapes kept: rings of squares become rings
// (Shirley, Chiu: A Low Distortion Map Between Disk and Square, Journal of Graphics Tools 1997).
static vec2s to_disc(vec2s square) {
    float x = 2 * square.x - 1, y = 2 * square.y - 1;
    bool is_wide = fabsf(x) > fabsf(y);
    float radius = is_wide ? x : y, ratio = radius == 0 ? 0 : (is_wide ? y : x) / radius;
    float angle = (float)GLM_PI_4f * ratio, along = radius * cosf(angle), across = radius * sinf(angle);
    return is_wide ? (vec2s){{along, across}} : (vec2s){{across, along}};
}

static Aim aim_at_area(const TruthArea *area, vec2s place) {
    vec3s offset = glms_vec3_add(glms_vec3_scale(area->right, place.x), glms_vec3_scale(area->up, place.y));
    return (Aim){.kind = AIM_POINT, .value = glms_vec3_add(area->center, offset), .limit = 1};
}

// `place` in [-1, 1]^2: where on a lamp with an extent.
static Aim aim_at_light(const Light *light, vec2s place) {
    vec3s forward = glms_vec3_sub(light->target, light->position);
    bool parallel = light->kind == LIGHT_DIRECTIONAL;
    if (parallel)
        return (Aim){.kind = AIM_DIRECTION, .value = glms_vec3_negate(forward), .limit = INFINITY};
    TruthArea area = {.center = light->position};
    light_axes(light, &area.right, &area.up);
    Aim aim = aim_at_area(&area, glms_vec2_scale(place, light->extent));
    aim.front = light->kind == LIGHT_SPOT ? forward : vec3_make(0, 0, 0);
    return aim;
}

static Aim aim_at_sky(vec2s disc, float limit) {
    float height = sqrtf(fmaxf(0, 1 - disc.x * disc.x - disc.y * disc.y));
    return (Aim){
        .kind = AIM_LOCAL, .value = vec3_make(disc.x, disc.y, height), .limit = limit > 0 ? limit : INFINITY};
}

static Aim aim_sample(const TruthQuery *query, const Light *light, vec2s square) {
    vec2s place = {{2 * square.x - 1, 2 * square.y - 1}};
    if (light)
        return aim_at_light(light, place);
    if (query->kind == TRUTH_DISC)
        return aim_at_area(&query->area, to_disc(square));
    if (query->kind == TRUTH_RECTANGLE)
        return aim_at_area(&query->area, place);
    return aim_at_sky(to_disc(square), query->limit);
}

static int strata_across(int samples) {
    int across = (int)sqrtf((float)samples);
    while (samples % across)
        across--;
    return across;
}

// Is this stratum of the query's part? Each part has strata from everywhere.
static bool is_part(const TruthQuery *query, int column, int row) {
    int side = query->parts > 0 ? (int)lrintf(sqrtf((float)query->parts)) : 1;
    return row % side * side + column % side == query->part;
}

static int aim_samples(const TruthQuery *query, const Light *light, int tile, Aim *aims) {
    // The tile's number is put through the generator once: neighbouring seeds share most of their sequence.
    Random random = {query->seed + (uint64_t)tile * 0xd1342543de82ef95u};
    random.state = random_next(&random);
    int across = strata_across(query->samples), down = query->samples / across, count = 0;
    for (int row = 0; row < down; row++)
        for (int column = 0; column < across; column++) {
            float x = ((float)column + random_range(&random, 0, 1)) / (float)across;
            float y = ((float)row + random_range(&random, 0, 1)) / (float)down;
            if (is_part(query, column, row))
                aims[count++] = aim_sample(query, light, (vec2s){{x, y}});
        }
    return count;
}

int aim_all(const Scene *scene, const TruthQuery *query, int tile, Aim *aims) {
    if (query->kind != TRUTH_LIGHT && query->kind != TRUTH_LIGHTS)
        return aim_samples(query, NULL, tile, aims);
    int first = query->kind == TRUTH_LIGHT ? query->light : 0;
    int count = query->kind == TRUTH_LIGHT ? 1 : scene->light_count, total = 0;
    bool wide = truth_is_wide(scene, query);
    for (const Light *light = &scene->lights[first]; light < &scene->lights[first + count]; light++)
        if (wide)
            total += aim_samples(query, light, tile, aims + total);
        else
            aims[total++] = aim_at_light(light, (vec2s){{0, 0}});
    return total;
}
