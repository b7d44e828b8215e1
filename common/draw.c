#include "draw.h"

#include "check.h"

#include <stddef.h>
#include <stdio.h>

typedef struct Model {
    GLuint vertex_array, buffers[2];
    GLsizei index_count;
} Model;

static Model models[SHAPE_COUNT];
static GLuint empty_vertex_array;

static void add_attribute(GLuint index, GLint components, size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, sizeof(Vertex), (const void *)offset);
}

static bool create_model(Model *model, Shape shape) {
    Mesh mesh;
    if (!mesh_create(&mesh, shape))
        return false;
    glGenVertexArrays(1, &model->vertex_array);
    glGenBuffers(2, model->buffers);
    glBindVertexArray(model->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, model->buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, mesh.vertex_count * (GLsizeiptr)sizeof(Vertex), mesh.vertices,
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, model->buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, mesh.index_count * (GLsizeiptr)sizeof(uint32_t), mesh.indices,
                 GL_STATIC_DRAW);
    add_attribute(0, 3, offsetof(Vertex, position));
    add_attribute(1, 3, offsetof(Vertex, normal));
    add_attribute(2, 2, offsetof(Vertex, uv));
    glBindVertexArray(0);
    model->index_count = mesh.index_count;
    mesh_destroy(&mesh);
    return true;
}

bool draw_create(void) {
    for (int shape = 0; shape < SHAPE_COUNT; shape++)
        if (!create_model(&models[shape], (Shape)shape))
            return false;
    glGenVertexArrays(1, &empty_vertex_array);
    return true;
}

void draw_destroy(void) {
    for (int shape = 0; shape < SHAPE_COUNT; shape++) {
        glDeleteVertexArrays(1, &models[shape].vertex_array);
        glDeleteBuffers(2, models[shape].buffers);
        models[shape] = (Model){0};
    }
    glDeleteVertexArrays(1, &empty_vertex_array);
    empty_vertex_array = 0;
}

void draw_to_frame(const Frame *frame) {
    glBindFramebuffer(GL_FRAMEBUFFER, frame->framebuffer);
    glViewport(0, 0, frame->width, frame->height);
}

mat4s draw_clip_from_world(const Frame *frame) {
    const Camera *camera = &frame->scene->camera;
    float aspect = (float)frame->width / (float)frame->height;
    return glms_mat4_mul(camera_clip_from_view(camera, aspect), camera_view_from_world(camera));
}

static void set_light(const Program *program, const Light *light, int i) {
    char name[64];
    snprintf(name, sizeof name, "u_lights[%d].position_world", i);
    glUniform3fv(program_find(program, name), 1, light->position.raw);
    snprintf(name, sizeof name, "u_lights[%d].target_world", i);
    glUniform3fv(program_find(program, name), 1, light->target.raw);
    snprintf(name, sizeof name, "u_lights[%d].color", i);
    glUniform3fv(program_find(program, name), 1, light->color.raw);
    snprintf(name, sizeof name, "u_lights[%d].is_directional", i);
    glUniform1i(program_find(program, name), light->kind == LIGHT_DIRECTIONAL);
}

void draw_begin(const Frame *frame, const Program *program, mat4s clip_from_world, vec3s eye) {
    const Scene *scene = frame->scene;
    glUseProgram(program->id);
    glUniformMatrix4fv(program_find(program, "u_clip_from_world"), 1, GL_FALSE, &clip_from_world.raw[0][0]);
    glUniform3fv(program_find(program, "u_eye_world"), 1, eye.raw);
    glUniform3fv(program_find(program, "u_ambient_light"), 1, scene->ambient.raw);
    glUniform1i(program_find(program, "u_flat_light"), frame->flat_light);
    glUniform1i(program_find(program, "u_light_count"), scene->light_count);
    for (int i = 0; i < scene->light_count; i++)
        set_light(program, &scene->lights[i], i);
}

static void draw_object(const Scene *scene, int i, const Program *program) {
    const Object *object = &scene->objects[i];
    const Model *model = &models[object->shape];
    glUniformMatrix4fv(program_find(program, "u_world_from_object"), 1, GL_FALSE,
                       &object->world_from_object.raw[0][0]);
    glUniform3fv(program_find(program, "u_color"), 1, object->color.raw);
    glUniform1f(program_find(program, "u_specular"), object->specular);
    glUniform1f(program_find(program, "u_shininess"), object->shininess);
    glUniform1i(program_find(program, "u_is_screen"), object->is_screen);
    glUniform1i(program_find(program, "u_object"), i);
    glBindVertexArray(model->vertex_array);
    glDrawElements(GL_TRIANGLES, model->index_count, GL_UNSIGNED_INT, NULL);
}

void draw_objects(const Frame *frame, const Program *program) {
    for (int i = 0; i < frame->scene->object_count; i++)
        draw_object(frame->scene, i, program);
    glBindVertexArray(0);
}

void draw_scene(const Frame *frame, const Program *program, mat4s clip_from_world, vec3s eye) {
    draw_begin(frame, program, clip_from_world, eye);
    draw_objects(frame, program);
}

void draw_fullscreen(const Program *program) {
    glUseProgram(program->id);
    glBindVertexArray(empty_vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}
