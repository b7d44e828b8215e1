#include "casters.h"

#include "adjacency.h"
#include "model.h"

#include <stdbool.h>

static Model casters[SHAPE_COUNT]; // without indices for an open shape

static bool create(Model *caster, Shape shape) {
    Mesh mesh;
    Adjacency adjacency = {0};
    bool ok = mesh_create(&mesh, shape) && adjacency_create(&adjacency, &mesh);
    if (ok && adjacency.open_edges == 0)
        model_create(caster, &mesh, adjacency.indices, adjacency.index_count);
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
        const Model *caster = &casters[object->shape];
        if (caster->index_count == 0)
            continue;
        program_set_mat4(program, "u_world_from_object", object->world_from_object);
        glBindVertexArray(caster->vertex_array);
        glDrawElements(GL_TRIANGLES_ADJACENCY, caster->index_count, GL_UNSIGNED_INT, NULL);
    }
    glBindVertexArray(0);
}
