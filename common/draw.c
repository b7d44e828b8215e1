// The meshes on the GPU, and what each frame tells its programs of scene, lights and objects.
#include "draw.h"

#include "model.h"

#include <stdio.h>
#include <string.h>

static Model models[SHAPE_COUNT];
static GLuint empty_vertex_array;

static bool create_model(Model *model, Shape shape) {
    Mesh mesh;
    if (!mesh_create(&mesh, shape))
        return false;
    model_create(model, &mesh, mesh.indices, mesh.index_count);
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
    for (int shape = 0; shape < SHAPE_COUNT; shape++)
        model_destroy(&models[shape]);
    glDeleteVertexArrays(1, &empty_vertex_array);
    empty_vertex_array = 0;
}

bool frame_shows(const Frame *frame, const char *stage) {
    return strcmp(frame->view, stage) == 0;
}

void frame_bind(const Frame *frame) {
    glBindFramebuffer(GL_FRAMEBUFFER, frame->framebuffer);
    glViewport(0, 0, frame->width, frame->height);
}

mat4s frame_clip_from_world(const Frame *frame) {
    const Camera *camera = &frame->scene->camera;
    float aspect = (float)frame->width / (float)frame->height;
    return glms_mat4_mul(camera_clip_from_view(camera, aspect), camera_view_from_world(camera));
}

// Stands where the scene has no more lights: who asks it sees it, and the same in each frame.
static const Light no_light = {
    .kind = LIGHT_DIRECTIONAL, .position = {{0.6f, 0.7f, 0.4f}}, .color = {{2, 0, 2}}};

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
    for (int i = 0; i < SCENE_MAX_LIGHTS; i++)
        set_light(program, i < scene->light_count ? &scene->lights[i] : &no_light, i);
}

void draw_object(const Frame *frame, const Program *program, int i) {
    const Object *object = &frame->scene->objects[i];
    const Model *model = &models[object->shape];
    glUniform1i(program_find(program, "u_object"), i);
    glUniformMatrix4fv(program_find(program, "u_world_from_object"), 1, GL_FALSE,
                       &object->world_from_object.raw[0][0]);
    glUniform3fv(program_find(program, "u_color"), 1, object->color.raw);
    glUniform1f(program_find(program, "u_specular"), object->specular);
    glUniform1f(program_find(program, "u_shininess"), object->shininess);
    glUniform1i(program_find(program, "u_is_screen"), object->is_screen);
    glBindVertexArray(model->vertex_array);
    glDrawElements(GL_TRIANGLES, model->index_count, GL_UNSIGNED_INT, NULL);
    glBindVertexArray(0);
}

void draw_objects(const Frame *frame, const Program *program) {
    for (int i = 0; i < frame->scene->object_count; i++)
        draw_object(frame, program, i);
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
