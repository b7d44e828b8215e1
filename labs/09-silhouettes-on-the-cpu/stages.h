// Given: the frame as the eye measures it, and the stages, which show the parts of the volumes.
#pragma once

#include "target.h"
#include "volumes.h"

#include <string.h>

// The frame with its scene moved so that the eye is at (0, 0, 0): what is near has small numbers then,
// wherever in the world it is, and small numbers round little.
static Frame from_eye(const Frame *frame, Scene *scene) {
    *scene = *frame->scene;
    const vec3s eye = scene->camera.eye;
    for (int i = 0; i < scene->object_count; i++)
        for (int k = 0; k < 3; k++)
            scene->objects[i].world_from_object.raw[3][k] -= eye.raw[k];
    for (int i = 0; i < scene->light_count; i++) {
        scene->lights[i].position = glms_vec3_sub(scene->lights[i].position, eye);
        scene->lights[i].target = glms_vec3_sub(scene->lights[i].target, eye);
    }
    scene->camera.target = glms_vec3_sub(scene->camera.target, eye);
    scene->camera.eye = vec3_make(0, 0, 0);
    Frame moved = *frame;
    moved.scene = scene;
    return moved;
}

static struct {
    Target lit, silhouette, sides, caps, around_eye;
    Shell lit_faces, fins;
} stages;

static bool stages_create(int width, int height) {
    Target *targets[] = {&stages.lit, &stages.silhouette, &stages.sides, &stages.caps, &stages.around_eye};
    bool ok = true;
    for (int i = 0; ok && i < 5; i++)
        ok = target_create(targets[i], width, height, GL_RGBA8, 0);
    return ok;
}

static void stages_destroy(void) {
    Target *targets[] = {&stages.lit, &stages.silhouette, &stages.sides, &stages.caps, &stages.around_eye};
    for (int i = 0; i < 5; i++)
        target_destroy(targets[i]);
    shell_destroy(&stages.lit_faces);
    shell_destroy(&stages.fins);
}

// The lit triangles, and a fin on each edge of the silhouette.
static void add_parts(const Caster *caster, const EdgeSet *set) {
    for (int t = 0; t < caster->triangle_count; t++)
        if (caster->lit[t])
            shell_add(&stages.lit_faces, glms_vec4(corner(caster, t, 0), 1),
                      glms_vec4(corner(caster, t, 1), 1), glms_vec4(corner(caster, t, 2), 1));
    for (int i = 0; i < set->count; i++) {
        vec3s a = caster->places[set->edges[i].a], b = caster->places[set->edges[i].b];
        vec3s middle = glms_vec3_scale(glms_vec3_add(a, b), 0.5f);
        vec3s away = glms_vec3_normalize(glms_vec3_negate(to_light(&caster->light, middle)));
        shell_add(&stages.fins, glms_vec4(a, 1), glms_vec4(b, 1),
                  glms_vec4(glms_vec3_muladds(away, 0.3f, middle), 1));
    }
}

static void make_parts(const Frame *frame) {
    stages.lit_faces.count = stages.fins.count = 0;
    for (int i = 0; i < frame->scene->object_count; i++) {
        const Caster *caster = place_object(&frame->scene->objects[i], &frame->scene->lights[0]);
        const EdgeSet set = find_edges(frame, caster);
        add_parts(caster, &set);
    }
}

// All triangles, in front of everything: red those that look to the eye, blue the others. Only in the stage
// that is looked at.
static void show_shell(const Frame *frame, const char *stage, const Shell *shell, const Target *target) {
    if (strcmp(frame->view, stage) != 0)
        return;
    target_bind(target);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    shell_draw(frame, shell);
}

// A row for each object, the first at the bottom: as many white bars as volumes of it hold the eye.
static void show_around_eye(const Frame *frame, const Target *target) {
    int rows = frame->scene->object_count, width = target->width / 4;
    target_bind(target);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glClearColor(1, 1, 1, 1);
    for (int row = 0; row < rows; row++)
        for (int i = 0; i < volumes.of_object[row] && i < 4; i++) {
            int bottom = row * target->height / rows, top = (row + 1) * target->height / rows;
            glScissor(i * width, bottom, width - 2, top - bottom - 1);
            glClear(GL_COLOR_BUFFER_BIT);
        }
    glDisable(GL_SCISSOR_TEST);
}

static void stages_draw(const Frame *frame) {
    make_parts(frame);
    gl_reset();
    glEnable(GL_DEPTH_CLAMP);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    show_shell(frame, "lit faces", &stages.lit_faces, &stages.lit);
    show_shell(frame, "silhouette", &stages.fins, &stages.silhouette);
    show_shell(frame, "sides", &volumes.sides, &stages.sides);
    show_shell(frame, "caps", &volumes.caps, &stages.caps);
    show_around_eye(frame, &stages.around_eye);
    gl_reset();
    frame_bind(frame);
}
