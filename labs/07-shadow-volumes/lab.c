// Lab 07: shadow volumes. Count in the stencil buffer how many volumes of shadow each visible point lies in.
#include "caster_volumes.h"
#include "frame_view.h"
#include "lab.h"

enum { KNOB_METHOD, KNOB_SILHOUETTES };
enum { PROGRAM_SPLIT, PROGRAM_VOLUME, PROGRAM_CPU_VOLUME, PROGRAM_TEXTURE, PROGRAM_CONSTANT };

static struct {
    GLuint framebuffer; // task 7.1, with these three attached, as large as the frame
    GLuint ambient, diffuse_specular, depth_stencil;
    FrameView view; // for the stages
} state;

static bool create_target(const Frame *frame) {
    // TODO(7.1): with target_create_texture make state.ambient and state.diffuse_specular (GL_RGBA8) and
    // state.depth_stencil (GL_DEPTH24_STENCIL8), as large as the frame; attach them to a new
    // state.framebuffer as colours 0 and 1 and as depth and stencil; draw into both colours. Look up:
    // glFramebufferTexture, GL_DEPTH_STENCIL_ATTACHMENT, glDrawBuffers.
    UNUSED(frame);
    return true; // then: return gl_check_framebuffer("two colours");
}

static bool create(const Frame *frame) {
    return create_target(frame) && frame_view_create(&state.view, frame) && casters_create();
}

static void destroy(void) {
    glDeleteFramebuffers(1, &state.framebuffer);
    glDeleteTextures(3, (GLuint[]){state.ambient, state.diffuse_specular, state.depth_stencil});
    frame_view_destroy(&state.view);
    casters_destroy();
    state.framebuffer = state.ambient = state.diffuse_specular = state.depth_stencil = 0;
}

// From the world to the clip space of the camera, for surfaces and volumes alike: their depths are compared.
static mat4s clip_from_world(const Frame *frame) {
    const Camera *camera = &frame->scene->camera;
    mat4s clip_from_view = camera_clip_from_view(camera, (float)frame->width / (float)frame->height);
    // TODO(7.8): a far plane would cut the volumes off. Let it go to infinity in the two elements that hold
    // it (the handout has the limits); raw[column][row].
    return glms_mat4_mul(clip_from_view, camera_view_from_world(camera));
}

// Pass 1: ambient light to one texture, diffuse and specular light to another.
static void draw_surfaces(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_SPLIT];
    vec3s sky = frame->flat_light ? vec3_make(0, 0, 0) : frame->scene->background;
    // TODO(7.1), second part: bind state.framebuffer; clear its colour 0 to sky, its colour 1 to black, and
    // its depth; draw the scene as below; copy colour 0 and the depth, all of them, to frame->framebuffer.
    // Look up: glClearBufferfv, glBlitFramebuffer with GL_READ_FRAMEBUFFER and GL_DRAW_FRAMEBUFFER.
    UNUSED(sky);
    draw_scene(frame, program, clip_from_world(frame), frame->scene->camera.eye);
}

// Pass 2: count the volumes between the eye and each visible point. Near caps lie on faces of their casters:
// the polygon offset puts them just behind, else rounding would decide.
static void draw_volumes(const Frame *frame) {
    bool z_fail = frame->knobs[KNOB_METHOD] > 0, on_cpu = frame->knobs[KNOB_SILHOUETTES] > 0;
    const Program *program = &frame->programs[on_cpu ? PROGRAM_CPU_VOLUME : PROGRAM_VOLUME];
    frame_bind(frame);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0, 16);
    // TODO(7.6): z-pass. Close the masks of colour and depth; draw back faces too; enable GL_STENCIL_TEST,
    // which always passes, and where the depth test does, front faces add one and back faces take one away,
    // with wrapping. Look up: glColorMask, glDepthMask, glEnable, glStencilFunc, glStencilOpSeparate. Until
    // then the volumes are seen, as haze.
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    if (z_fail) {
        // TODO(7.9): z-fail. Count where the depth test fails instead: there back faces add one and
        // front faces take one away. A cap at infinity (depth 1) must pass before an empty sky (depth 1
        // too). Look up: glDepthFunc.
    }
    program_set_vec3(program, "u_constant", vec3_make(0.1f, 0.1f, 0));
    draw_begin(frame, program, clip_from_world(frame), frame->scene->camera.eye);
    if (on_cpu) {
        casters_draw_volumes(frame);
    } else {
        casters_draw(frame, program);
    }
    // TODO(7.6), second part: open the mask of the colour again, for the next pass.
}

// Pass 3: diffuse and specular light where no volume was counted.
static void draw_light(const Frame *frame) {
    glDisable(GL_DEPTH_TEST);
    // TODO(7.3): add state.diffuse_specular to the picture where the stencil is 0, without changing the
    // stencil: draw a full-screen triangle with PROGRAM_TEXTURE. Look up: glBlendFunc, glStencilFunc,
    // glStencilOp, program_set_texture and draw_fullscreen in common/, u_texture in shaders/texture.frag.
    UNUSED(frame);
}

static void show_stages(const Frame *frame) {
    frame_view_draw(&state.view, frame, state.framebuffer, &frame->programs[PROGRAM_CONSTANT]);
    frame_view_draw_haze(&state.view, frame, state.framebuffer, &frame->programs[PROGRAM_VOLUME],
                         &frame->programs[PROGRAM_CONSTANT], clip_from_world(frame));
}

const Lab lab = {
    .title = "Shadow volumes",
    .programs = {[PROGRAM_SPLIT] = {"scene.vert", "split.frag", NULL},
                 [PROGRAM_VOLUME] = {"scene.vert", "constant.frag", "volume.geom"},
                 [PROGRAM_CPU_VOLUME] = {"volume.vert", "constant.frag", NULL},
                 [PROGRAM_TEXTURE] = {"fullscreen.vert", "texture.frag", NULL},
                 [PROGRAM_CONSTANT] = {"fullscreen.vert", "constant.frag", NULL}},
    .knobs = {[KNOB_METHOD] = {"method", "", 0, 1, 1, {"z-pass", "z-fail"}},
              [KNOB_SILHOUETTES] = {"silhouettes", "", 0, 1, 0, {"geometry shader", "CPU"}}},
    .passes = {{"surfaces", draw_surfaces},
               {"volumes", draw_volumes, PASS_PREPARE},
               {"light", draw_light},
               {"stages", show_stages, PASS_SHOW}},
    .stages = {{"diffuse and specular", &state.diffuse_specular}, FRAME_VIEW_STAGES(state.view)},
    .create = create,
    .destroy = destroy,
};
