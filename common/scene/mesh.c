// Makes the meshes of the unit shapes, face by face.
#include "scene/mesh.h"

#include "scene/check.h"

#include <stdlib.h>

enum { SPHERE_SLICES = 32, SPHERE_STACKS = 16, ARCH_CORNERS = 8 };

static bool reserve(Mesh *mesh, int vertices, int indices) {
    *mesh = (Mesh){.vertices = calloc((size_t)vertices, sizeof *mesh->vertices),
                   .indices = calloc((size_t)indices, sizeof *mesh->indices)};
    if (mesh->vertices && mesh->indices)
        return true;
    mesh_destroy(mesh);
    return check_fail("out of memory for a mesh of %d vertices", vertices);
}

static void add_triangle(Mesh *mesh, int a, int b, int c) {
    const int corners[3] = {a, b, c};
    for (int i = 0; i < 3; i++)
        mesh->indices[mesh->index_count++] = (uint32_t)corners[i];
}

// A square of side 2 around `normal`, spanned by `right` and `up` with cross(right, up) = normal.
static void add_square(Mesh *mesh, vec3s center, vec3s right, vec3s up) {
    const float corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    int first = mesh->vertex_count;
    for (int i = 0; i < 4; i++) {
        vec3s across = glms_vec3_scale(right, corner[i][0]), along = glms_vec3_scale(up, corner[i][1]);
        mesh->vertices[mesh->vertex_count++] =
            (Vertex){.position = glms_vec3_add(center, glms_vec3_add(across, along)),
                     .normal = glms_vec3_cross(right, up),
                     .uv = {{0.5f + 0.5f * corner[i][0], 0.5f + 0.5f * corner[i][1]}}};
    }
    add_triangle(mesh, first, first + 1, first + 2);
    add_triangle(mesh, first, first + 2, first + 3);
}

static void add_plane(Mesh *mesh) {
    add_square(mesh, vec3_make(0, 0, 0), vec3_make(1, 0, 0), vec3_make(0, 0, -1));
}

static void add_box(Mesh *mesh) {
    const vec3s axis[3] = {vec3_make(1, 0, 0), vec3_make(0, 1, 0), vec3_make(0, 0, 1)};
    for (int i = 0; i < 3; i++) {
        vec3s right = axis[(i + 1) % 3], up = axis[(i + 2) % 3];
        add_square(mesh, axis[i], right, up);
        add_square(mesh, glms_vec3_negate(axis[i]), up, right);
    }
}

static Vertex sphere_vertex(int slice, int stack) {
    float u = (float)slice / SPHERE_SLICES, v = (float)stack / SPHERE_STACKS;
    float azimuth = 2 * (float)GLM_PI * u, polar = (float)GLM_PI * v;
    vec3s p = vec3_make(sinf(polar) * cosf(azimuth), cosf(polar), -sinf(polar) * sinf(azimuth));
    return (Vertex){.position = p, .normal = p, .uv = {{u, 1 - v}}};
}

static void add_sphere(Mesh *mesh) {
    for (int stack = 0; stack <= SPHERE_STACKS; stack++)
        for (int slice = 0; slice <= SPHERE_SLICES; slice++)
            mesh->vertices[mesh->vertex_count++] = sphere_vertex(slice, stack);
    for (int stack = 0; stack < SPHERE_STACKS; stack++)
        for (int slice = 0; slice < SPHERE_SLICES; slice++) {
            int a = stack * (SPHERE_SLICES + 1) + slice, b = a + SPHERE_SLICES + 1;
            if (stack < SPHERE_STACKS - 1)
                add_triangle(mesh, a, b, b + 1);
            if (stack > 0)
                add_triangle(mesh, a, b + 1, a + 1);
        }
}

// Counter-clockwise seen from +z.
static const float arch[ARCH_CORNERS][2] = {{-1, -1},   {-0.5f, -1}, {-0.5f, 0.5f}, {0.5f, 0.5f},
                                            {0.5f, -1}, {1, -1},     {1, 1},        {-1, 1}};

// The face of the arch at z = 1 or -1: both legs, and the beam in two parts.
static void add_arch_face(Mesh *mesh, float z) {
    static const int faces[6][3] = {{0, 1, 2}, {0, 2, 7}, {2, 3, 7}, {3, 6, 7}, {3, 4, 6}, {4, 5, 6}};
    int first = mesh->vertex_count;
    for (int i = 0; i < ARCH_CORNERS; i++)
        mesh->vertices[mesh->vertex_count++] =
            (Vertex){.position = vec3_make(arch[i][0], arch[i][1], z), .normal = vec3_make(0, 0, z)};
    for (int i = 0; i < 6; i++)
        add_triangle(mesh, first + faces[i][0], first + faces[i][z > 0 ? 1 : 2],
                     first + faces[i][z > 0 ? 2 : 1]);
}

static void add_arch(Mesh *mesh) {
    add_arch_face(mesh, 1);
    add_arch_face(mesh, -1);
    for (int i = 0; i < ARCH_CORNERS; i++) {
        const float *from = arch[i], *to = arch[(i + 1) % ARCH_CORNERS];
        vec3s center = vec3_make((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, 0);
        vec3s along = vec3_make((to[0] - from[0]) / 2, (to[1] - from[1]) / 2, 0);
        int first = mesh->vertex_count;
        add_square(mesh, center, along, vec3_make(0, 0, 1));
        for (int k = 0; k < 4; k++) {
            vec3s *normal = &mesh->vertices[first + k].normal;
            *normal = glms_vec3_normalize(*normal);
        }
    }
}

bool mesh_create(Mesh *mesh, Shape shape) {
    static const struct {
        int vertices, indices;
        void (*add)(Mesh *mesh);
    } recipes[SHAPE_COUNT] = {
        [SHAPE_PLANE] = {4, 6, add_plane},
        [SHAPE_BOX] = {24, 36, add_box},
        [SHAPE_SPHERE] = {(SPHERE_SLICES + 1) * (SPHERE_STACKS + 1), SPHERE_SLICES * (SPHERE_STACKS - 1) * 6,
                          add_sphere},
        [SHAPE_ARCH] = {6 * ARCH_CORNERS, 6 * ARCH_CORNERS + 36, add_arch},
    };
    INVARIANT(shape >= 0 && shape < SHAPE_COUNT);
    if (!reserve(mesh, recipes[shape].vertices, recipes[shape].indices))
        return false;
    recipes[shape].add(mesh);
    INVARIANT(mesh->vertex_count == recipes[shape].vertices && mesh->index_count == recipes[shape].indices);
    return true;
}

void mesh_destroy(Mesh *mesh) {
    free(mesh->vertices);
    free(mesh->indices);
    *mesh = (Mesh){0};
}
