// Given: drawing the volumes, and the stages that show their parts.
#pragma once

#include "target.h"
#include "volumes.h"

static struct { Target lit, silhouette, sides, caps, around_eye; } stages;

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
}

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

// Draws the triangles with the program of volume.vert, in one colour.
static void shell_draw(const Frame *frame, const Shell *shell, vec3s color) {
    const Program *program = &frame->programs[PROGRAM_VOLUME];
    program_set_vec3(program, "u_constant", color);
    program_set_mat4(program, "u_world_from_object", glms_mat4_identity());
    draw_begin(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
    glBindVertexArray(volumes.array);
    glBindBuffer(GL_ARRAY_BUFFER, volumes.buffer);
    glBufferData(GL_ARRAY_BUFFER, shell->count * (GLsizeiptr)sizeof *shell->corners, shell->corners,
                 GL_STREAM_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, NULL);
    glDrawArrays(GL_TRIANGLES, 0, shell->count);
    glBindVertexArray(0);
}

// All triangles, in front of everything: red those that look to the eye, blue the others.
static void show_shell(const Frame *frame, const Shell *shell, const Target *target) {
    target_bind(target);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (int back = 0; back < 2; back++) {
        glCullFace(back ? GL_FRONT : GL_BACK);
        shell_draw(frame, shell, vec3_make(back ? 0 : 0.25f, 0.1f, back ? 0.25f : 0));
    }
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

static void show_parts_of_volumes(const Frame *frame) {
    volumes_make(frame, true);
    gl_reset();
    glEnable(GL_DEPTH_CLAMP);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    show_shell(frame, &volumes.lit, &stages.lit);
    show_shell(frame, &volumes.fins, &stages.silhouette);
    show_shell(frame, &volumes.sides, &stages.sides);
    show_shell(frame, &volumes.caps, &stages.caps);
    show_around_eye(frame, &stages.around_eye);
    gl_reset();
    frame_bind(frame);
}
