// Lab 11: several lights, and lights with an area. A map for each light in one array of maps, six for a lamp
// in the middle of the scene, and many for a wide light.
#include "lab.h"
#include "cube.h"
#include "maps.h"
#include "show.h"

static struct {
    GLuint framebuffer;
    GLuint maps;  // task 11.1: GL_TEXTURE_2D_ARRAY, layer k is map k of the list
    GLuint cubes; // GL_TEXTURE_CUBE_MAP_ARRAY, cube i (layers 6 i to 6 i + 5) is that of light i
    int size;     // of all maps, texels along a side
    Shown shown;
} state;

static bool create(const Frame *frame) {
    state.size = (int)frame->knobs[KNOB_MAP_SIZE];
    state.maps = create_map_array(state.size, most_maps(frame));
    state.cubes = create_cube_array(state.size);
    state.framebuffer = create_depth_framebuffer();
    return shown_create(&state.shown, frame, state.size);
}

static void destroy(void) {
    glDeleteFramebuffers(1, &state.framebuffer);
    glDeleteTextures(1, &state.maps);
    glDeleteTextures(1, &state.cubes);
    state.framebuffer = state.maps = state.cubes = 0;
    shown_destroy(&state.shown);
}

// From now on, what is drawn goes to this layer of a depth texture, which is cleared.
static void begin_layer(GLuint texture, int layer) {
    // TODO(11.2): this attaches all layers at once, and then everything goes to layer 0, so that the last map
    // takes the place of all others. Attach the one layer. Look up: glFramebufferTextureLayer.
    glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture, 0);
    glClear(GL_DEPTH_BUFFER_BIT);
    UNUSED(layer);
}

// What all maps need.
static void begin_maps(void) {
    glBindFramebuffer(GL_FRAMEBUFFER, state.framebuffer);
    glViewport(0, 0, state.size, state.size);
    glEnable(GL_POLYGON_OFFSET_FILL); // one for all maps: the filter asks one texel around (see lab 05)
    glPolygonOffset(3, 8);
}

static void draw_maps(const Frame *frame) {
    const MapList list = list_maps(frame);
    if (!state.maps)
        return;
    begin_maps();
    for (int k = 0; k < list.count; k++) {
        const Light *light = &list.lights[k];
        begin_layer(state.maps, k);
        draw_scene(frame, &frame->programs[PROGRAM_DEPTH], shadow_map_clip_from_world(light),
                   light->position);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
}

static void draw_cubes(const Frame *frame) {
    begin_maps();
    for (int i = 0; i < frame->scene->light_count; i++) {
        const Light *light = &frame->scene->lights[i];
        for (int face = 0; face < CUBE_FACES && light->kind == LIGHT_POINT; face++) {
            begin_layer(state.cubes, CUBE_FACES * i + face);
            draw_scene(frame, &frame->programs[PROGRAM_DEPTH], face_clip_from_world(light, face),
                       light->position);
        }
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
}

// The scene with all its lights; or how many maps each of its points has asked.
static void shade(const Frame *frame, bool show_asked) {
    const Program *program = &frame->programs[PROGRAM_SHADE];
    const MapList list = list_maps(frame);
    if (frame->knobs[KNOB_SEAMS] > 0)
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS); // off, see the handout
    program_set_texture(program, "u_maps", 0, GL_TEXTURE_2D_ARRAY, state.maps);
    program_set_texture(program, "u_cubes", 1, GL_TEXTURE_CUBE_MAP_ARRAY, state.cubes);
    program_set_int(program, "u_shadows", frame->knobs[KNOB_SHADOWS] > 0);
    program_set_int(program, "u_show_asked", show_asked);
    set_map_uniforms(program, &list);
    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
}

static void draw_picture(const Frame *frame) {
    frame_bind(frame);
    shade(frame, false);
}

static void show(const Frame *frame) {
    show_maps(&state.shown, state.framebuffer, state.maps, list_maps(frame).count);
    show_cube(&state.shown, state.framebuffer, state.cubes, frame->scene);
    if (show_asked_begin(&state.shown, frame))
        shade(frame, true);
}

const Lab lab = {
    .title = "Several and wide lights",
    .programs = {[PROGRAM_DEPTH] = {"scene.vert", "empty.frag", NULL},
                 [PROGRAM_SHADE] = {"scene.vert", "shade.frag", NULL}},
    .knobs = {[KNOB_SHADOWS] = {"shadows", "", 0, 1, 1, {"none", "all"}},
              [KNOB_MAP_SIZE] = {"map size", "texels", 16, 1024, 256},
              [KNOB_LAMPS] = {"lamps", "along a side", 1, 8, 4},
              [KNOB_JITTER] = {"jitter", "cells", 0, 1, 1},
              [KNOB_SEAMS] = {"cube filter", "", 0, 1, 0, {"each face", "across faces"}}},
    .passes = {{"maps", draw_maps, PASS_PREPARE},
               {"cubes", draw_cubes, PASS_PREPARE},
               {"picture", draw_picture},
               {"stages", show, PASS_SHOW}},
    .stages = {{"maps", &state.shown.maps.depth},
               {"cube", &state.shown.cube.depth},
               {"asked", &state.shown.asked.color}},
    .create = create,
    .destroy = destroy,
};
