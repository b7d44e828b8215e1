#include "casters.h"

#include "model.h"
#include "scene/silhouette.h"

#include <stdbool.h>

typedef struct Caster {
    Mesh mesh;
    Adjacency adjacency;
    Model model; // without indices for an open shape
} Caster;

static Caster casters[SHAPE_COUNT];

static bool create(Caster *caster, Shape shape) {
    if (!mesh_create(&caster->mesh, shape) || !adjacency_create(&caster->adjacency, &caster->mesh))
        return false;
    if (caster->adjacency.open_edges == 0)
        model_create(&caster->model, &caster->mesh, caster->adjacency.indices, caster->adjacency.index_count);
    return true;
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
        const Model *caster = &casters[object->shape].model;
        if (caster->index_count == 0)
            continue;
        program_set_mat4(program, "u_world_from_object", object->world_from_object);
        glBindVertexArray(caster->vertex_array);
        glDrawElements(GL_TRIANGLES_ADJACENCY, caster->index_count, GL_UNSIGNED_INT, NULL);
    }
    glBindVertexArray(0);
}

static void draw_volume(const Volume *volume) {
    static GLuint vertex_array, buffer;
    if (!buffer) {
        glGenVertexArrays(1, &vertex_array);
        glGenBuffers(1, &buffer);
    }
    glBindVertexArray(vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, volume->count * (GLsizeiptr)sizeof *volume->corners, volume->corners,
                 GL_STREAM_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, NULL);
    glDrawArrays(GL_TRIANGLES, 0, volume->count);
    glBindVertexArray(0);
}

void casters_draw_volumes(const Frame *frame) {
    static Volume volume; // kept, so that its memory is there in the next frame
    volume.count = 0;
    if (!create_all())
        return;
    for (int i = 0; i < frame->scene->object_count; i++) {
        const Object *object = &frame->scene->objects[i];
        const Caster *caster = &casters[object->shape];
        if (caster->adjacency.open_edges == 0 &&
            !silhouette_add(&volume, &caster->mesh, &caster->adjacency, object->world_from_object,
                            &frame->scene->lights[0]))
            return;
    }
    draw_volume(&volume);
}
