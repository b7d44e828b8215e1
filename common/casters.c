#include "casters.h"

#include "adjacency.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct Caster {
    GLuint vertex_array;
    GLsizei index_count; // 0 for an open shape
} Caster;

static Caster casters[SHAPE_COUNT];

static void upload(Caster *caster, const Mesh *mesh, const Adjacency *adjacency) {
    GLuint buffers[2];
    glGenVertexArrays(1, &caster->vertex_array);
    glGenBuffers(2, buffers);
    glBindVertexArray(caster->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, mesh->vertex_count * (GLsizeiptr)sizeof(Vertex), mesh->vertices,
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, adjacency->index_count * (GLsizeiptr)sizeof(uint32_t),
                 adjacency->indices, GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), (const void *)offsetof(Vertex, position));
    caster->index_count = adjacency->index_count;
}

static bool create(Caster *caster, Shape shape) {
    Mesh mesh;
    Adjacency adjacency = {0};
    bool ok = mesh_create(&mesh, shape) && adjacency_create(&adjacency, &mesh);
    if (ok && adjacency.open_edges == 0)
        upload(caster, &mesh, &adjacency);
    adjacency_destroy(&adjacency);
    mesh_destroy(&mesh);
    return ok;
}

static bool create_all(void) {
    static bool created;
    for (int shape = 0; !created && shape < SHAPE_COUNT; shape++)
        if (!create(&casters[shape], (Shape)shape))
            return false;
    created = true;
    return true;
}

void casters_draw(const Frame *frame, const Program *program) {
    if (!create_all())
        return;
    for (int i = 0; i < frame->scene->object_count; i++) {
        const Object *object = &frame->scene->objects[i];
        const Caster *caster = &casters[object->shape];
        if (caster->index_count == 0)
            continue;
        program_set_mat4(program, "u_world_from_object", object->world_from_object);
        glBindVertexArray(caster->vertex_array);
        glDrawElements(GL_TRIANGLES_ADJACENCY, caster->index_count, GL_UNSIGNED_INT, NULL);
    }
    glBindVertexArray(0);
}
