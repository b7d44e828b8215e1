// Lab 13: light volumes. Sum the light that dust sends to the eye: step by step by a shadow map, and exactly
// by the faces of the shadow volumes.
#include "lab.h"
#include "layers.h"
#include "shadow_map.h"
#include "target.h"

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
    return shadow_map_create(&state.map, (int)frame->knobs[KNOB_MAP_SIZE], GL_DEPTH_COMPONENT32F) &&
           target_create(&state.surfaces, width, height, GL_RGBA8, GL_DEPTH_COMPONENT32F) &&
           layers_create(&state.layers, width, height) && grey_create(&state.dust, width, height) &&
           grey_create(&state.distance, width, height) &&
           target_create(&state.interval, width, height, GL_RGBA8, 0) && casters_create();
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

// Pass 1, given.
static void draw_map(const Frame *frame) {
    const Light *light = &frame->scene->lights[0];
    shadow_map_begin(&state.map);
    draw_scene(frame, &frame->programs[PROGRAM_MAP], shadow_map_clip_from_world(light), light->position);
}

// Pass 2, given: the surfaces as they are without dust.
static void draw_surfaces(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_SHADE];
    vec3s sky = frame->scene->background;
    target_bind(&state.surfaces);
    glClearColor(sky.x, sky.y, sky.z, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    set_map(frame, program, state.map.texture);
    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
}

// Pass 3: the faces of each shadow volume into a layer of its own. The layers have no depth buffer: a face
// behind what is seen must not get lost.
static void draw_faces(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_FACE];
    if ((int)frame->knobs[KNOB_DUST] != DUST_FACES)
        return;
    set_air(frame, program, state.surfaces.depth);
    draw_begin(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
#ifdef SOLUTION // 13.8
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glEnable(GL_DEPTH_CLAMP);
#else
    // TODO(13.8): draw the back faces too; let what is drawn be added to what is there; and let neither the
    // near nor the far plane cut a face away. Look up: glBlendFunc, GL_DEPTH_CLAMP.
#endif
    layers_draw(&state.layers, frame);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_BLEND);
    glEnable(GL_CULL_FACE);
}

// Pass 4, given: the dust by one of the two ways, or none.
static void draw_dust(const Frame *frame) {
    bool faces = (int)frame->knobs[KNOB_DUST] == DUST_FACES;
    const Program *program = &frame->programs[faces ? PROGRAM_MERGE : PROGRAM_MARCH];
    target_bind(&state.dust);
    glDisable(GL_DEPTH_TEST);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    if ((int)frame->knobs[KNOB_DUST] == DUST_NONE)
        return;
    set_air(frame, program, state.surfaces.depth);
    if (faces) {
        layers_bind(&state.layers, program);
    } else {
        set_map(frame, program, state.map.texture);
        program_set_int(program, "u_steps", (int)frame->knobs[KNOB_STEPS]);
        program_set_float(program, "u_jitter", frame->knobs[KNOB_JITTER]);
    }
    draw_over_all(frame, program);
}

// Pass 5, given.
static void draw_picture(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_PICTURE];
    frame_bind(frame);
    glDisable(GL_DEPTH_TEST);
    set_air(frame, program, state.surfaces.depth);
    program_set_int(program, "u_shows_distance", false);
    program_set_texture(program, "u_surfaces", 1, GL_TEXTURE_2D, state.surfaces.color);
    program_set_texture(program, "u_dust", 2, GL_TEXTURE_2D, state.dust.color);
    draw_over_all(frame, program);
}

// Given: the stages "distance" (20 units are white) and "interval", the first caster's layer.
static void show(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_PICTURE];
    target_bind(&state.distance);
    glDisable(GL_DEPTH_TEST);
    program_set_int(program, "u_shows_distance", true);
    draw_over_all(frame, program);
    layers_show(&state.layers, &state.interval);
}

const Lab lab = {
    .title = "Light volumes",
    .programs = {[PROGRAM_MAP] = {"scene.vert", "empty.frag", NULL},
                 [PROGRAM_SHADE] = {"scene.vert", "shade.frag", NULL},
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
