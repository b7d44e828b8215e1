#include "casters.h"

#include "adjacency.h"

#include <stddef.h>

static void upload(Casters *casters, Shape shape, const Mesh *mesh, const Adjacency *adjacency) {
    GLuint *buffers = casters->shapes[shape].buffers;
    glGenVertexArrays(1, &casters->shapes[shape].vertex_array);
    glGenBuffers(2, buffers);
    glBindVertexArray(casters->shapes[shape].vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, mesh->vertex_count * (GLsizeiptr)sizeof(Vertex), mesh->vertices,
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, adjacency->index_count * (GLsizeiptr)sizeof(uint32_t),
                 adjacency->indices, GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), (const void *)offsetof(Vertex, position));
    glBindVertexArray(0);
    casters->shapes[shape].index_count = adjacency->index_count;
}

bool casters_create(Casters *casters) {
    *casters = (Casters){0};
    for (int shape = 0; shape < SHAPE_COUNT; shape++) {
        Mesh mesh;
        Adjacency adjacency = {0};
        bool ok = mesh_create(&mesh, (Shape)shape) && adjacency_create(&adjacency, &mesh);
        if (ok && adjacency.open_edges == 0)
            upload(casters, (Shape)shape, &mesh, &adjacency);
        adjacency_destroy(&adjacency);
        mesh_destroy(&mesh);
        if (!ok)
            return false;
    }
    return true;
}

void casters_destroy(Casters *casters) {
    for (int shape = 0; shape < SHAPE_COUNT; shape++) {
        glDeleteVertexArrays(1, &casters->shapes[shape].vertex_array);
        glDeleteBuffers(2, casters->shapes[shape].buffers);
    }
    *casters = (Casters){0};
}

void casters_draw(const Casters *casters, const Frame *frame, const Program *program) {
    for (int i = 0; i < frame->scene->object_count; i++) {
        const Object *object = &frame->scene->objects[i];
        if (casters->shapes[object->shape].index_count == 0)
            continue;
        program_set_mat4(program, "u_world_from_object", object->world_from_object);
        glBindVertexArray(casters->shapes[object->shape].vertex_array);
        glDrawElements(GL_TRIANGLES_ADJACENCY, casters->shapes[object->shape].index_count, GL_UNSIGNED_INT,
                       NULL);
    }
    glBindVertexArray(0);
}
