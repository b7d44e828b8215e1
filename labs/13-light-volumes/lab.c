// Lab 13: light volumes. Sum the light that dust sends to the eye: step by step by a shadow map, and exactly
// by the faces of the shadow volumes. All passes but pass 3 are given.
#include "air.h"
#include "lab.h"
#include "layers.h"

enum { KNOB_DUST, KNOB_STEPS, KNOB_JITTER, KNOB_MAP_SIZE };
enum { DUST_NONE, DUST_MARCH, DUST_FACES };
enum { PROGRAM_MAP, PROGRAM_SHADE, PROGRAM_FACE, PROGRAM_MARCH, PROGRAM_MERGE, PROGRAM_PICTURE };

static struct {
    ShadowMap map;
    Target surfaces; // what is seen through clear air, and its depth
    Layers layers;   // for each caster where the ray of a pixel enters its shadow, and where it leaves it
    Target dust;     // for each pixel what the dust before it scatters, grey
    Target distance, interval; // to look at
} state;

static bool create(const Frame *frame) {
    int width = frame->width, height = frame->height;
    int most = (int)frame->knobs[KNOB_DUST] == DUST_FACES ? LAYERS : 0; // volumes: none without the faces
    return shadow_map_create(&state.map, (int)frame->knobs[KNOB_MAP_SIZE], GL_DEPTH_COMPONENT32F) &&
           target_create(&state.surfaces, width, height, GL_RGBA8, GL_DEPTH_COMPONENT32F) &&
           layers_create(&state.layers, width, height, most) && grey_create(&state.dust, width, height) &&
           target_create(&state.distance, width, height, GL_RGBA8, 0) && (!most || casters_create()) &&
           target_create(&state.interval, width, height, GL_RG32F, 0);
}

static void destroy(void) {
    shadow_map_destroy(&state.map);
    target_destroy(&state.surfaces);
    layers_destroy(&state.layers);
    target_destroy(&state.dust);
    target_destroy(&state.distance);
    target_destroy(&state.interval);
    casters_destroy();
}

// Pass 1.
static void draw_map(const Frame *frame) {
    air_draw_map(frame, &frame->programs[PROGRAM_MAP], &state.map);
}

// Pass 2: the surfaces as they are without dust.
static void draw_surfaces(const Frame *frame) {
    air_draw_surfaces(frame, &frame->programs[PROGRAM_SHADE], &state.surfaces, &state.map);
}

// Pass 3: the faces of each shadow volume into a layer of its own. The layers have no depth buffer: a face
// behind what is seen must not get lost.
static void draw_faces(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_FACE];
    if ((int)frame->knobs[KNOB_DUST] != DUST_FACES)
        return;
    set_air(frame, program, state.surfaces.depth);
    draw_begin(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
    // TODO(13.8): draw the back faces too; let what is drawn be added to what is there; and let neither the
    // near nor the far plane cut a face away. Look up: glBlendFunc, GL_DEPTH_CLAMP.
    layers_draw(&state.layers, frame);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_BLEND);
    glEnable(GL_CULL_FACE);
}

// Pass 4: the dust by one of the two ways, or none.
static void draw_dust(const Frame *frame) {
    bool faces = (int)frame->knobs[KNOB_DUST] == DUST_FACES;
    const Program *program = &frame->programs[faces ? PROGRAM_MERGE : PROGRAM_MARCH];
    air_begin_dust(&state.dust);
    if ((int)frame->knobs[KNOB_DUST] == DUST_NONE)
        return;
    set_air(frame, program, state.surfaces.depth);
    if (faces) {
        layers_bind(&state.layers, program);
    } else {
        set_map(frame, program, &state.map);
        program_set_int(program, "u_steps", (int)frame->knobs[KNOB_STEPS]);
        program_set_float(program, "u_jitter", frame->knobs[KNOB_JITTER]);
    }
    draw_over_all(frame, program);
}

// Pass 5.
static void draw_picture(const Frame *frame) {
    frame_bind(frame);
    air_draw_picture(frame, &frame->programs[PROGRAM_PICTURE], &state.surfaces, &state.dust);
}

// The stages "distance" and "interval", the first caster's layer.
static void show(const Frame *frame) {
    if (frame_shows(frame, "distance"))
        air_show_distance(frame, &frame->programs[PROGRAM_PICTURE], &state.surfaces, &state.distance);
    if (frame_shows(frame, "interval"))
        layers_show(&state.layers, &state.interval);
}

const Lab lab = {
    .title = "Light volumes",
    .programs = {[PROGRAM_MAP] = {"scene.vert", "empty.frag", NULL},
                 [PROGRAM_SHADE] = {"scene.vert", "shadowed.frag", NULL},
                 [PROGRAM_FACE] = {"volume.vert", "face.frag", NULL},
                 [PROGRAM_MARCH] = {"fullscreen.vert", "march.frag", NULL},
                 [PROGRAM_MERGE] = {"fullscreen.vert", "merge.frag", NULL},
                 [PROGRAM_PICTURE] = {"fullscreen.vert", "picture.frag", NULL}},
    .knobs = {[KNOB_DUST] = {"dust", "", 0, 2, 2, {"none", "march", "faces"}},
              [KNOB_STEPS] = {"steps", "", 1, 64, 24},
              [KNOB_JITTER] = {"jitter", "steps", 0, 1, 1},
              [KNOB_MAP_SIZE] = {"map size", "texels", 64, 2048, 1024}},
    .passes = {{"map", draw_map, PASS_PREPARE},
               {"surfaces", draw_surfaces},
               {"faces", draw_faces, PASS_PREPARE},
               {"dust", draw_dust},
               {"picture", draw_picture},
               {"stages", show, PASS_SHOW}},
    .stages = {{"dust", &state.dust.color},
               {"distance", &state.distance.color},
               {"interval", &state.interval.color}},
    .create = create,
    .destroy = destroy,
};
