// The dark segments of each ray from the eye, triangle by triangle, and the light of what they leave.
#include "truth/dust.h"

#include "scene/check.h"
#include "truth/primary.h"
#include "truth/tile.h"

#include <math.h>
#include <stdlib.h>

enum { WEDGE_SIDES = 4, MOST_SEGMENTS = 2048 }; // disjoint ones, at any time

// Segments nearer to each other than this (world units) are one: neighbours of a mesh share an edge but for
// rounding.
static const double SEAM = 1e-6;

// Where the ray is inside of all sides, the triangle keeps the light away: inside means that normal . t *
// direction + at_eye > 0.
typedef struct Wedge {
    double normal[WEDGE_SIDES][3], at_eye[WEDGE_SIDES];
} Wedge;

typedef struct Segment {
    double from, to;
} Segment;

typedef struct Dust {
    const Truth *truth;
    const TruthPicture *picture;
    const Light *light;
    Wedge *wedges; // owned
    int wedge_count;
    PrimaryRays primary;
    float *scattered;
} Dust;

typedef struct Triangle {
    double corners[3][3];
} Triangle;

static void subtract(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[i] - b[i];
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void widen(vec3s v, double out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = v.raw[i];
}

// From the point to the light, of any length.
static void to_light(const Light *light, const double point[3], double out[3]) {
    double position[3], from[3];
    widen(light->position, position);
    widen(light->target, from);
    subtract(position, light->kind == LIGHT_DIRECTIONAL ? from : point, out);
}

// The side through `point` whose normal, turned where necessary, has a positive product with `inwards`.
static void set_side(Wedge *wedge, int i, const double normal[3], const double point[3],
                     const double inwards[3], vec3s eye) {
    double from_point[3], sign = dot(normal, inwards) > 0 ? 1 : -1, at[3];
    widen(eye, at);
    subtract(at, point, from_point);
    for (int c = 0; c < 3; c++)
        wedge->normal[i][c] = sign * normal[c];
    wedge->at_eye[i] = sign * dot(normal, from_point);
}

// Does the triangle look to the light? Of one that the light only grazes, nobody minds the answer.
static double facing(const Light *light, const Triangle *triangle, double normal[3]) {
    double across[3], along[3], lamp[3];
    subtract(triangle->corners[1], triangle->corners[0], across);
    subtract(triangle->corners[2], triangle->corners[0], along);
    cross(across, along, normal);
    to_light(light, triangle->corners[0], lamp);
    return dot(normal, lamp);
}

static Wedge make_wedge(const Light *light, const Triangle *triangle, const double normal[3], vec3s eye) {
    Wedge wedge;
    double away[3], lamp[3], edge[3], side[3], third[3];
    to_light(light, triangle->corners[0], lamp);
    for (int c = 0; c < 3; c++)
        away[c] = -lamp[c];
    set_side(&wedge, 3, normal, triangle->corners[0], away, eye);
    for (int i = 0; i < 3; i++) {
        const double *a = triangle->corners[i], *b = triangle->corners[(i + 1) % 3];
        subtract(b, a, edge);
        to_light(light, a, lamp);
        cross(edge, lamp, side);
        subtract(triangle->corners[(i + 2) % 3], a, third);
        set_side(&wedge, i, side, a, third, eye);
    }
    return wedge;
}

// Of a closed mesh the triangles that look to the light do: their wedges are the whole shadow.
static void add_object(Dust *dust, int i) {
    const Object *object = &dust->truth->scene.objects[i];
    const Mesh *mesh = &dust->truth->meshes[object->shape];
    for (int first = 0; first < mesh->index_count; first += 3) {
        Triangle triangle;
        double normal[3];
        for (int c = 0; c < 3; c++)
            widen(glms_mat4_mulv3(object->world_from_object,
                                  mesh->vertices[mesh->indices[first + c]].position, 1),
                  triangle.corners[c]);
        double faces = facing(dust->light, &triangle, normal);
        if (faces > 0 || (object->shape == SHAPE_PLANE && faces < 0))
            dust->wedges[dust->wedge_count++] =
                make_wedge(dust->light, &triangle, normal, dust->truth->scene.camera.eye);
    }
}

// The part of the ray inside of the wedge; empty when from >= to. `direction` has length 1.
static Segment cut(const Wedge *wedge, const double direction[3], double end) {
    Segment inside = {0, end};
    for (int i = 0; i < WEDGE_SIDES; i++) {
        double slope = dot(wedge->normal[i], direction), at = wedge->at_eye[i];
        if (slope > 0)
            inside.from = fmax(inside.from, -at / slope);
        else if (slope < 0)
            inside.to = fmin(inside.to, -at / slope);
        else if (at <= 0)
            inside.to = 0;
    }
    return inside;
}

// Behind a spot light it is dark.
static Segment behind(const Light *light, vec3s eye, const double direction[3], double end) {
    double axis[3], position[3], at[3], from_lamp[3];
    widen(glms_vec3_sub(light->target, light->position), axis);
    widen(light->position, position);
    widen(eye, at);
    subtract(at, position, from_lamp);
    double height = dot(axis, from_lamp), slope = dot(axis, direction);
    double border = slope != 0 ? -height / slope : end;
    if (light->kind != LIGHT_SPOT)
        return (Segment){0, 0};
    if (slope > 0)
        return (Segment){0, height < 0 ? fmin(border, end) : 0};
    return (Segment){height > 0 ? fmin(border, end) : 0, end};
}

// Adds a segment to a sorted list of disjoint ones; returns how many there are then.
static int add_segment(Segment *list, int count, Segment segment) {
    if (segment.from >= segment.to)
        return count;
    int first = 0, last = 0;
    while (first < count && list[first].to < segment.from - SEAM)
        first++;
    for (last = first; last < count && list[last].from <= segment.to + SEAM; last++) {
        segment.from = fmin(segment.from, list[last].from);
        segment.to = fmax(segment.to, list[last].to);
    }
    int added = 1 - (last - first);
    INVARIANT(count + added <= MOST_SEGMENTS);
    if (added > 0)
        for (int i = count; i > first; i--)
            list[i] = list[i - 1];
    for (int i = last; added < 0 && i < count; i++)
        list[i + added] = list[i];
    list[first] = segment;
    return count + added;
}

// The sum of e^(-extinction t) from 0 to `distance`.
static double gathered(const Medium *medium, double distance) {
    double extinction = medium->extinction;
    return extinction > 0 ? -expm1(-extinction * distance) / extinction : distance;
}

static double trace_ray(const Dust *dust, const double direction[3], double end) {
    const Scene *scene = &dust->truth->scene;
    Segment dark[MOST_SEGMENTS];
    int count = add_segment(dark, 0, behind(dust->light, scene->camera.eye, direction, end));
    for (int i = 0; i < dust->wedge_count; i++)
        count = add_segment(dark, count, cut(&dust->wedges[i], direction, end));
    double sum = gathered(&scene->medium, end);
    for (int i = 0; i < count; i++)
        sum -= gathered(&scene->medium, dark[i].to) - gathered(&scene->medium, dark[i].from);
    return scene->medium.scattering * fmax(sum, 0);
}

static void trace_row(int row, void *context) {
    const Dust *dust = context;
    const Camera *camera = &dust->truth->scene.camera;
    for (int column = 0; column < dust->picture->width; column++) {
        size_t pixel = (size_t)row * (size_t)dust->picture->width + (size_t)column;
        const TruthHit *hit = &dust->picture->hits[pixel];
        vec3s sky = primary_direction(&dust->primary, column, row, (vec2s){{0.5f, 0.5f}});
        bool hits = hit->object != TRUTH_NONE;
        vec3s ray =
            hits ? glms_vec3_sub(hit->position, camera->eye) : glms_vec3_scale(sky, camera->far_plane);
        double direction[3], length = glms_vec3_norm(ray);
        widen(ray, direction);
        for (int c = 0; c < 3; c++)
            direction[c] /= length;
        dust->scattered[pixel] = (float)trace_ray(dust, direction, length);
    }
}

void dust_trace(const Truth *truth, const TruthPicture *picture, int light, float *scattered) {
    const Scene *scene = &truth->scene;
    int most = 0;
    for (int i = 0; i < scene->object_count; i++)
        most += truth->meshes[scene->objects[i].shape].index_count / 3;
    Dust dust = {.truth = truth,
                 .picture = picture,
                 .light = &scene->lights[light],
                 .wedges = calloc((size_t)most + 1, sizeof *dust.wedges),
                 .primary = primary_rays(&scene->camera, picture->width, picture->height),
                 .scattered = scattered};
    INVARIANT(dust.wedges);
    for (int i = 0; i < scene->object_count; i++)
        add_object(&dust, i);
    tile_each_row(picture->height, trace_row, &dust);
    free(dust.wedges);
}
