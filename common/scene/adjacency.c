#include "scene/adjacency.h"

#include "scene/check.h"

#include <stdlib.h>

// Vertices nearer than this are one: a sphere's seam is off by a rounding of sin(2 pi).
static const float WELD = 1e-5f;

// A directed edge of a triangle and the corner that is not on it.
typedef struct Edge {
    uint32_t from, to, far_corner;
} Edge;

// For each vertex the first one in its place.
static uint32_t *weld(const Mesh *mesh) {
    uint32_t *first = calloc((size_t)mesh->vertex_count, sizeof *first);
    for (int i = 0; first && i < mesh->vertex_count; i++)
        while (glms_vec3_distance2(mesh->vertices[first[i]].position, mesh->vertices[i].position) >
               WELD * WELD)
            first[i]++;
    return first;
}

// The indices of the mesh, welded.
static uint32_t *list_corners(const Mesh *mesh) {
    uint32_t *corners = calloc((size_t)mesh->index_count, sizeof *corners), *first = weld(mesh);
    for (int i = 0; corners && first && i < mesh->index_count; i++)
        corners[i] = first[mesh->indices[i]];
    bool ok = corners && first;
    free(first);
    if (ok)
        return corners;
    free(corners);
    return NULL;
}

static int compare_edges(const void *a, const void *b) {
    const Edge *x = a, *y = b;
    if (x->from != y->from)
        return x->from < y->from ? -1 : 1;
    return x->to < y->to ? -1 : x->to > y->to;
}

// All directed edges, sorted.
static Edge *list_edges(const uint32_t *corners, int count) {
    Edge *edges = calloc((size_t)count, sizeof *edges);
    if (!edges)
        return NULL;
    for (int i = 0; i < count; i++) {
        const uint32_t *triangle = corners + i - i % 3;
        edges[i] = (Edge){triangle[i % 3], triangle[(i + 1) % 3], triangle[(i + 2) % 3]};
    }
    qsort(edges, (size_t)count, sizeof *edges, compare_edges);
    return edges;
}

// The edge, or NULL where there is none or more than one.
static const Edge *find_only(const Edge *edges, int count, uint32_t from, uint32_t to) {
    const Edge wanted = {.from = from, .to = to};
    const Edge *edge = bsearch(&wanted, edges, (size_t)count, sizeof *edges, compare_edges);
    if (!edge || (edge > edges && compare_edges(edge - 1, edge) == 0) ||
        (edge + 1 < edges + count && compare_edges(edge + 1, edge) == 0))
        return NULL;
    return edge;
}

static void connect(Adjacency *adjacency, const uint32_t *corners, const Edge *edges, int count) {
    for (int i = 0; i < count; i++) {
        const uint32_t *triangle = corners + i - i % 3;
        const int first = i + i / 3; // triangles begin at their first, second or third corner, in turn
        uint32_t from = triangle[first % 3], to = triangle[(first + 1) % 3];
        const Edge *neighbour = find_only(edges, count, to, from);
        bool closed = neighbour && find_only(edges, count, from, to);
        adjacency->indices[2 * i] = from;
        adjacency->indices[2 * i + 1] = closed ? neighbour->far_corner : triangle[(first + 2) % 3];
        adjacency->open_edges += !closed;
    }
}

bool adjacency_create(Adjacency *adjacency, const Mesh *mesh) {
    int count = mesh->index_count;
    *adjacency = (Adjacency){.indices = calloc(2 * (size_t)count, sizeof *adjacency->indices),
                             .index_count = 2 * count};
    uint32_t *corners = list_corners(mesh);
    Edge *edges = corners ? list_edges(corners, count) : NULL;
    bool ok = adjacency->indices && edges;
    if (ok)
        connect(adjacency, corners, edges, count);
    free(edges);
    free(corners);
    if (!ok)
        adjacency_destroy(adjacency);
    return ok || check_fail("out of memory for the neighbours of %d triangles", count / 3);
}

void adjacency_destroy(Adjacency *adjacency) {
    free(adjacency->indices);
    *adjacency = (Adjacency){0};
}
