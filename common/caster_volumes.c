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

// A new array of vertices, bound, with its buffer.
static GLuint begin_array(GLuint *buffer) {
    GLuint array;
    glGenVertexArrays(1, &array);
    glGenBuffers(1, buffer);
    glBindVertexArray(array);
    glBindBuffer(GL_ARRAY_BUFFER, *buffer);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, NULL);
    return array;
}

// False for an open shape, which has no volume, and when there is no memory.
static bool make_volume(Volume *volume, const Scene *scene, int i) {
    const Object *object = &scene->objects[i];
    const Adjacency *adjacency = casters_adjacency((Shape)object->shape);
    volume->count = 0;
    return adjacency->open_edges == 0 && silhouette_add(volume, casters_mesh((Shape)object->shape), adjacency,
                                                        object->world_from_object, &scene->lights[0]);
}

// Draws the volumes of objects first to end - 1; the number of those that have one.
static int draw_volumes(const Scene *scene, int first, int end) {
    Volume volume = {0};
    GLuint buffer, array = begin_array(&buffer);
    int drawn = 0;
    for (int i = first; i < end; i++) {
        if (!make_volume(&volume, scene, i))
            continue;
        draw_volume(&volume, scene->objects[i].world_from_object);
        drawn++;
    }
    silhouette_destroy(&volume);
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &array);
    glDeleteBuffers(1, &buffer);
    return drawn;
}

void casters_draw_volumes(const Frame *frame) {
    casters_note_clamp();
    draw_volumes(frame->scene, 0, frame->scene->object_count);
}

bool casters_draw_volume(const Frame *frame, int i) {
    return draw_volumes(frame->scene, i, i + 1) > 0;
}
