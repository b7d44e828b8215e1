#include "frame_view.h"

#include "casters.h"
#include "gl_state.h"

bool frame_view_create(FrameView *view, const Frame *frame) {
    return target_create(&view->counts, frame->width, frame->height, GL_RGBA8, GL_DEPTH24_STENCIL8) &&
           target_create(&view->rows, frame->width, FRAME_VIEW_ROWS, GL_RGBA8, 0) &&
           target_create(&view->haze, frame->width, frame->height, GL_RGBA8, GL_DEPTH24_STENCIL8);
}

void frame_view_destroy(FrameView *view) {
    target_destroy(&view->counts);
    target_destroy(&view->rows);
    target_destroy(&view->haze);
}

// Colours the pixels with this stencil value.
static void fill(const Program *program, int value, vec3s color) {
    glStencilFunc(GL_EQUAL, value, 0xff);
    program_set_vec3(program, "u_constant", color);
    draw_fullscreen(program);
}

static void draw_counts(const Frame *frame, const Program *program, const Target *counts) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame->framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, counts->framebuffer);
    glBlitFramebuffer(0, 0, frame->width, frame->height, 0, 0, frame->width, frame->height,
                      GL_STENCIL_BUFFER_BIT, GL_NEAREST);
    target_bind(counts);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    for (int count = 0; count < 4; count++) {
        fill(program, count, vec3_make((float)count / 4, (float)count / 4, (float)count / 4));
        fill(program, 255 - count, vec3_make(1, (float)count / 4, 0));
    }
}

static void copy_rows(const Frame *frame, const Target *rows) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame->framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, rows->framebuffer);
    glBlitFramebuffer(0, frame->height - rows->height, frame->width, frame->height, 0, 0, rows->width,
                      rows->height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void frame_view_draw(const FrameView *view, const Frame *frame, const Program *program) {
    gl_reset();
    copy_rows(frame, &view->rows);
    draw_counts(frame, program, &view->counts);
    gl_reset();
    frame_bind(frame);
}

static void copy_depth(const Frame *frame, GLuint surfaces, const Target *target) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, surfaces ? surfaces : frame->framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target->framebuffer);
    glBlitFramebuffer(0, 0, frame->width, frame->height, 0, 0, frame->width, frame->height,
                      GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

// The polygon offset puts near caps behind the faces on which they lie; far caps have the depth of the empty
// sky. So the sides alone are seen.
void frame_view_draw_haze(const FrameView *view, const Frame *frame, GLuint surfaces, const Program *volumes,
                          mat4s clip_from_world) {
    gl_reset();
    copy_depth(frame, surfaces, &view->haze);
    target_bind(&view->haze);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDepthMask(GL_FALSE);
    glEnable(GL_DEPTH_CLAMP);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0, 16);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    draw_begin(frame, volumes, clip_from_world, frame->scene->camera.eye);
    for (int back = 0; back < 2; back++) {
        glCullFace(back ? GL_FRONT : GL_BACK);
        program_set_vec3(volumes, "u_constant", vec3_make(back ? 0 : 0.2f, 0.1f, back ? 0.2f : 0));
        casters_draw(frame, volumes);
    }
    gl_reset();
    frame_bind(frame);
}
