// The shapes that cast shadow volumes, and the volumes of a frame.
#include "casters.h"

#include "model.h"

#include <stdbool.h>

typedef struct CasterModel {
    Mesh mesh;
    Adjacency adjacency;
    Model model; // without indices for an open shape
} CasterModel;

static CasterModel casters[SHAPE_COUNT];
static bool were_clamped;

static bool create(CasterModel *caster, Shape shape) {
    if (!mesh_create(&caster->mesh, shape) || !adjacency_create(&caster->adjacency, &caster->mesh))
        return false;
    if (caster->adjacency.open_edges == 0)
        model_create(&caster->model, &caster->mesh, caster->adjacency.indices, caster->adjacency.index_count);
    return true;
}

static void destroy(CasterModel *caster) {
    mesh_destroy(&caster->mesh);
    adjacency_destroy(&caster->adjacency);
    model_destroy(&caster->model);
}

bool casters_create(void) {
    for (int shape = 0; shape < SHAPE_COUNT; shape++)
        if (!create(&casters[shape], (Shape)shape))
            return false;
    return true;
}

void casters_destroy(void) {
    for (int shape = 0; shape < SHAPE_COUNT; shape++)
        destroy(&casters[shape]);
}

void casters_note_clamp(void) {
    were_clamped = glIsEnabled(GL_DEPTH_CLAMP);
}

bool casters_were_clamped(void) {
    return were_clamped;
}

void casters_draw(const Frame *frame, const Program *program) {
    casters_note_clamp();
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

const Mesh *casters_mesh(Shape shape) {
    return &casters[shape].mesh;
}

const Adjacency *casters_adjacency(Shape shape) {
    return &casters[shape].adjacency;
}
