// The shapes that cast shadow volumes, and the volumes of a frame.
#include "casters.h"

#include "model.h"
#include "scene/silhouette.h"

#include <stdbool.h>

typedef struct CasterModel {
    Mesh mesh;
    Adjacency adjacency;
    Model model; // without indices for an open shape
} CasterModel;

static CasterModel casters[SHAPE_COUNT];
static Volume volume; // its memory serves all frames
static GLuint volume_array, volume_buffer;
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
    glGenVertexArrays(1, &volume_array);
    glGenBuffers(1, &volume_buffer);
    return true;
}

void casters_destroy(void) {
    for (int shape = 0; shape < SHAPE_COUNT; shape++)
        destroy(&casters[shape]);
    silhouette_destroy(&volume);
    glDeleteVertexArrays(1, &volume_array);
    glDeleteBuffers(1, &volume_buffer);
    volume_array = volume_buffer = 0;
}

bool casters_were_clamped(void) {
    return were_clamped;
}

void casters_draw(const Frame *frame, const Program *program) {
    were_clamped = glIsEnabled(GL_DEPTH_CLAMP);
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

static void draw_volume(void) {
    glBindVertexArray(volume_array);
    glBindBuffer(GL_ARRAY_BUFFER, volume_buffer);
    glBufferData(GL_ARRAY_BUFFER, volume.count * (GLsizeiptr)sizeof *volume.corners, volume.corners,
                 GL_STREAM_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, NULL);
    glDrawArrays(GL_TRIANGLES, 0, volume.count);
    glBindVertexArray(0);
}

// False for an open shape, which has no volume, and when there is no memory.
static bool add_volume(const Frame *frame, int i) {
    const Object *object = &frame->scene->objects[i];
    const CasterModel *caster = &casters[object->shape];
    return caster->adjacency.open_edges == 0 &&
           silhouette_add(&volume, &caster->mesh, &caster->adjacency, object->world_from_object,
                          &frame->scene->lights[0]);
}

void casters_draw_volumes(const Frame *frame) {
    were_clamped = glIsEnabled(GL_DEPTH_CLAMP);
    volume.count = 0;
    for (int i = 0; i < frame->scene->object_count; i++)
        add_volume(frame, i);
    draw_volume();
}

bool casters_draw_volume(const Frame *frame, int i) {
    volume.count = 0;
    bool closed = add_volume(frame, i);
    if (closed)
        draw_volume();
    return closed;
}
