#include "caster_volumes.h"

#include "scene/silhouette.h"

// Corners stay in the object's space until volume.vert takes them to the world as scene.vert takes the
// surfaces: near caps and the faces on which they lie get the same depth, however far from the origin.
static void draw_volume(const Volume *volume, mat4s world_from_object) {
    GLint program;
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    glUniformMatrix4fv(glGetUniformLocation((GLuint)program, "u_world_from_object"), 1, GL_FALSE,
                       &world_from_object.raw[0][0]);
    glBufferData(GL_ARRAY_BUFFER, volume->count * (GLsizeiptr)sizeof *volume->corners, volume->corners,
                 GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, volume->count);
}

static void draw_volumes(const Scene *scene) {
    Volume volume = {0};
    for (int i = 0; i < scene->object_count; i++) {
        const Object *object = &scene->objects[i];
        const Adjacency *adjacency = casters_adjacency((Shape)object->shape);
        volume.count = 0;
        if (adjacency->open_edges == 0 &&
            silhouette_add(&volume, casters_mesh((Shape)object->shape), adjacency, object->world_from_object,
                           &scene->lights[0]))
            draw_volume(&volume, object->world_from_object);
    }
    silhouette_destroy(&volume);
}

void casters_draw_volumes(const Frame *frame) {
    GLuint array, buffer;
    glGenVertexArrays(1, &array);
    glGenBuffers(1, &buffer);
    glBindVertexArray(array);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, NULL);
    draw_volumes(frame->scene);
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &array);
    glDeleteBuffers(1, &buffer);
}
