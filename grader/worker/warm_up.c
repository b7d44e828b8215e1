#include "worker/warm_up.h"

#include "draw.h"
#include "gl_state.h"
#include "program.h"
#include "target.h"

enum { SIDE = 64 };

static void draw(const Program *program, const Scene *scene, const Target *target) {
    const Frame frame = {
        .scene = scene, .framebuffer = target->framebuffer, .width = SIDE, .height = SIDE, .view = "picture"};
    gl_reset();
    frame_bind(&frame);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    draw_scene(&frame, program, frame_clip_from_world(&frame), scene->camera.eye);
}

static Scene plain_scene(void) {
    const mat4s place = glms_mat4_identity();
    const vec3s eye = vec3_make(1, 2, 3), middle = vec3_make(0, 0, 0), white = vec3_make(1, 1, 1);
    const Light light = {
        .position = eye, .target = middle, .color = white, .fov_y = 1, .near_plane = 1, .far_plane = 9};
    return (Scene){.objects = {{.world_from_object = place, .color = white, .shininess = 1}},
                   .lights = {light},
                   .camera = {.eye = eye, .target = middle, .fov_y = 1, .near_plane = 1, .far_plane = 9},
                   .object_count = 1,
                   .light_count = 1};
}

// The driver compiles anew for textures of another format, and for sides that are powers of two.
static bool view_textures(const StageView *view, const Target *shown) {
    static const GLenum formats[][2] = {{0, GL_DEPTH_COMPONENT24}, {GL_RGBA32F, 0}};
    Target stage;
    for (int i = 0; i < 4; i++) {
        const int side = i % 2 ? SIDE : SIDE - 4;
        if (!target_create(&stage, side, side, formats[i / 2][0], formats[i / 2][1]))
            return false;
        stage_view_draw(view, shown, i / 2 ? stage.color : stage.depth, false);
        glFinish();
        target_destroy(&stage);
    }
    return true;
}

bool warm_up(const StageView *view) {
    static float pixels[SIDE * SIDE * 4];
    const Scene scene = plain_scene();
    Program program = {0};
    Target target = {0}, shown = {0};
    bool ok = program_create(&program, &(ProgramFiles){"scene.vert", "unshadowed.frag", NULL}) &&
              target_create(&target, SIDE, SIDE, GL_RGBA32F, GL_DEPTH24_STENCIL8) &&
              target_create(&shown, SIDE, SIDE, GL_RGBA32F, 0);
    if (ok) {
        draw(&program, &scene, &target);
        ok = view_textures(view, &shown);
        glReadPixels(0, 0, SIDE, SIDE, GL_RGBA, GL_FLOAT, pixels);
    }
    target_destroy(&shown);
    target_destroy(&target);
    program_destroy(&program);
    gl_reset();
    gl_clear_error();
    return ok;
}
