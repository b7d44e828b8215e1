#include "model.h"

#include <stddef.h>

static void add_attribute(GLuint index, GLint components, size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, sizeof(Vertex), (const void *)offset);
}

void model_create(Model *model, const Mesh *mesh, const uint32_t *indices, int index_count) {
    glGenVertexArrays(1, &model->vertex_array);
    glGenBuffers(2, model->buffers);
    glBindVertexArray(model->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, model->buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, mesh->vertex_count * (GLsizeiptr)sizeof(Vertex), mesh->vertices,
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, model->buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, index_count * (GLsizeiptr)sizeof(uint32_t), indices,
                 GL_STATIC_DRAW);
    add_attribute(0, 3, offsetof(Vertex, position));
    add_attribute(1, 3, offsetof(Vertex, normal));
    add_attribute(2, 2, offsetof(Vertex, uv));
    glBindVertexArray(0);
    model->index_count = index_count;
}

void model_destroy(Model *model) {
    glDeleteVertexArrays(1, &model->vertex_array);
    glDeleteBuffers(2, model->buffers);
    *model = (Model){0};
}
