// Shows what the stencil, the depth and the volumes of a frame hold, in the stage that is asked for.
#include "frame_view.h"

#include "casters.h"
#include "gl_state.h"
#include "scene/count.h"

#include <string.h>

// How the faces of the volumes are shown.
typedef struct Haze {
    const char *stage;
    GLenum depth_function;
    float offset; // of the polygons, away from the eye: near caps lie on faces of their casters
    float strength;
    bool clamp; // no plane cuts them off
    bool is_fins, over_surfaces;
} Haze;

// The offset puts near caps behind the faces on which they lie, or with GL_GEQUAL surely there; far caps have
// the depth of the empty sky. So before what is seen there are the sides alone. Where a lab clamps depths,
// all beyond its far plane has the depth of the sky, sides and far caps: so to the horizon both are shown.
static const Haze hazes[] = {
    {"fins", GL_LESS, -16, 3, true, true, false},
    {"haze", GL_LESS, 16, 1, true, false, false},
    {"haze behind", GL_GEQUAL, 16, 1, true, false, false},
    {"haze to the horizon", GL_LEQUAL, 16, 1, false, false, true},
};

bool frame_view_create(FrameView *view, const Frame *frame) {
    return target_create(&view->ambient, frame->width, frame->height, GL_RGBA8, 0) &&
           target_create(&view->counts, frame->width, frame->height, GL_RGBA8, GL_DEPTH24_STENCIL8) &&
           target_create(&view->rows, frame->width, FRAME_VIEW_ROWS, GL_RGBA8, 0) &&
           target_create(&view->haze, frame->width, frame->height, GL_RGBA8, GL_DEPTH24_STENCIL8);
}

void frame_view_destroy(FrameView *view) {
    target_destroy(&view->ambient);
    target_destroy(&view->counts);
    target_destroy(&view->rows);
    target_destroy(&view->haze);
}

// Copies all of one framebuffer to another one of the frame's size.
static void copy(const Frame *frame, GLuint from, GLuint to, GLbitfield what) {
    const int width = frame->width, height = frame->height;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, what, GL_NEAREST);
}

static void clear(const Target *target, float grey) {
    target_bind(target);
    glClearColor(grey, grey, grey, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

static void copy_ambient(const Frame *frame, GLuint surfaces, const Target *ambient) {
    clear(ambient, 0);
    if (surfaces)
        copy(frame, surfaces, ambient->framebuffer, GL_COLOR_BUFFER_BIT);
}

// Colours the pixels with this stencil value.
static void fill(const Program *program, int value, vec3s color) {
    glStencilFunc(GL_EQUAL, value, 0xff);
    program_set_vec3(program, "u_constant", color);
    draw_fullscreen(program);
}

static void draw_counts(const Frame *frame, const Program *program, const Target *counts) {
    copy(frame, frame->framebuffer, counts->framebuffer, GL_STENCIL_BUFFER_BIT);
    clear(counts, 1);
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

void frame_view_draw(const FrameView *view, const Frame *frame, GLuint surfaces, const Program *constant) {
    gl_reset();
    if (strcmp(frame->view, "ambient") == 0)
        copy_ambient(frame, surfaces, &view->ambient);
    if (strcmp(frame->view, "last rows") == 0)
        copy_rows(frame, &view->rows);
    if (strcmp(frame->view, "stencil counts") == 0)
        draw_counts(frame, constant, &view->counts);
    gl_reset();
    frame_bind(frame);
}

// Grey where the depth is less than that of the empty sky.
static void mark_surfaces(const Program *constant) {
    glDepthRange(1, 1);
    glDepthFunc(GL_GREATER);
    program_set_vec3(constant, "u_constant", vec3_make(0.5f, 0.5f, 0.5f));
    draw_fullscreen(constant);
    glDepthRange(0, 1);
}

static void set(GLenum state, bool on) {
    if (on)
        glEnable(state);
    else
        glDisable(state);
}

// A geometry shader that is all a student's own has no fins.
static void set_fins(const Program *volumes, bool on) {
    GLint place = program_find(volumes, "u_fins");
    if (place >= 0)
        glProgramUniform1i(volumes->id, place, on);
}

static void draw_faces(const Frame *frame, const Haze *haze, const Program *volumes, mat4s clip_from_world) {
    glDepthFunc(haze->depth_function);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0, haze->offset);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    draw_begin(frame, volumes, clip_from_world, frame->scene->camera.eye);
    set_fins(volumes, haze->is_fins);
    for (int back = 0; back < 2; back++) {
        glCullFace(back ? GL_FRONT : GL_BACK);
        vec3s color = vec3_make(back ? 0 : 0.2f, 0.1f, back ? 0.2f : 0);
        program_set_vec3(volumes, "u_constant", glms_vec3_scale(color, haze->strength));
        casters_draw(frame, volumes);
    }
    set_fins(volumes, false);
}

void frame_view_draw_haze(const FrameView *view, const Frame *frame, GLuint surfaces, const Program *volumes,
                          const Program *constant, mat4s clip_from_world) {
    const bool clamped = casters_were_clamped();
    gl_reset();
    for (size_t i = 0; i < COUNT(hazes); i++) {
        if (strcmp(frame->view, hazes[i].stage) != 0)
            continue;
        clear(&view->haze, 0);
        copy(frame, surfaces ? surfaces : frame->framebuffer, view->haze.framebuffer, GL_DEPTH_BUFFER_BIT);
        target_bind(&view->haze);
        glDepthMask(GL_FALSE);
        if (hazes[i].over_surfaces)
            mark_surfaces(constant);
        set(GL_DEPTH_CLAMP, hazes[i].clamp || clamped);
        draw_faces(frame, &hazes[i], volumes, clip_from_world);
    }
    gl_reset();
    frame_bind(frame);
}
