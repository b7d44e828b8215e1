// Finds the sides of shadow volumes on the CPU, triangle by triangle.
#include "scene/silhouette.h"

#include "scene/check.h"

#include <stdlib.h>

enum { MOST = 24 }; // corners that one triangle of the mesh adds: two caps and three sides

// In the object's space, where numbers are small wherever the object stands. A flat face that looks to the
// light there does so in the world.
typedef struct Caster {
    const Mesh *mesh;
    vec3s light; // where a lamp is, or the direction to a sun
    bool parallel;
} Caster;

static bool reserve(Volume *volume) {
    if (volume->count + MOST <= volume->capacity)
        return true;
    int capacity = 2 * volume->capacity + 1024;
    vec4s *corners = realloc(volume->corners, (size_t)capacity * sizeof *corners);
    if (!corners)
        return check_fail("out of memory for a shadow volume of %d corners", capacity);
    volume->corners = corners;
    volume->capacity = capacity;
    return true;
}

static Caster make_caster(const Mesh *mesh, mat4s world_from_object, const Light *light) {
    bool parallel = light->kind == LIGHT_DIRECTIONAL;
    vec3s from = parallel ? light->target : glms_vec3(world_from_object.col[3]);
    mat3s object_from_world = glms_mat3_inv(glms_mat4_pick3(world_from_object));
    return (Caster){mesh, glms_mat3_mulv(object_from_world, glms_vec3_sub(light->position, from)), parallel};
}

static vec3s place(const Caster *caster, uint32_t vertex) {
    return caster->mesh->vertices[vertex].position;
}

static vec3s to_light(const Caster *caster, vec3s p) {
    return caster->parallel ? caster->light : glms_vec3_sub(caster->light, p);
}

// Of the triangle's corners in the order of the mesh's numbers, whoever asks: at grazing light rounding
// decides, and must decide alike for a triangle and its neighbours.
static bool faces_light(const Caster *caster, uint32_t i, uint32_t j, uint32_t k) {
    while (j < i || k < i) {
        uint32_t first = i;
        i = j;
        j = k;
        k = first;
    }
    vec3s a = place(caster, i), b = place(caster, j), c = place(caster, k);
    vec3s normal = glms_vec3_cross(glms_vec3_sub(b, a), glms_vec3_sub(c, a));
    return glms_vec3_dot(normal, to_light(caster, a)) > 0;
}

static vec4s here(const Caster *caster, uint32_t vertex) {
    return glms_vec4(place(caster, vertex), 1);
}

static vec4s at_infinity(const Caster *caster, uint32_t vertex) {
    return glms_vec4(glms_vec3_negate(glms_vec3_normalize(to_light(caster, place(caster, vertex)))), 0);
}

static void add_triangle(Volume *volume, vec4s a, vec4s b, vec4s c) {
    volume->corners[volume->count++] = a;
    volume->corners[volume->count++] = b;
    volume->corners[volume->count++] = c;
}

static void add_caps(Volume *volume, const Caster *caster, const uint32_t *corners) {
    uint32_t a = corners[0], b = corners[2], c = corners[4];
    add_triangle(volume, here(caster, a), here(caster, b), here(caster, c));
    add_triangle(volume, at_infinity(caster, a), at_infinity(caster, c), at_infinity(caster, b));
}

static void add_side(Volume *volume, const Caster *caster, uint32_t a, uint32_t b) {
    add_triangle(volume, here(caster, a), at_infinity(caster, a), here(caster, b));
    add_triangle(volume, here(caster, b), at_infinity(caster, a), at_infinity(caster, b));
}

bool silhouette_add(Volume *volume, const Mesh *mesh, const Adjacency *adjacency, mat4s world_from_object,
                    const Light *light) {
    const Caster caster = make_caster(mesh, world_from_object, light);
    INVARIANT(adjacency->open_edges == 0);
    for (int i = 0; i < adjacency->index_count; i += 6) {
        const uint32_t *corners = adjacency->indices + i;
        if (!faces_light(&caster, corners[0], corners[2], corners[4]))
            continue;
        if (!reserve(volume))
            return false;
        add_caps(volume, &caster, corners);
        for (int e = 0; e < 6; e += 2) {
            uint32_t from = corners[e], to = corners[(e + 2) % 6];
            if (!faces_light(&caster, from, corners[e + 1], to))
                add_side(volume, &caster, from, to);
        }
    }
    return true;
}

void silhouette_destroy(Volume *volume) {
    free(volume->corners);
    *volume = (Volume){0};
}
