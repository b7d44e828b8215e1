// Lab 12: light maps. The light that arrives is computed once, for each luxel, and looked up ever after.
#include "lab.h"
#include "luxels.h"
#include "passes.h"

enum { LUXEL_BYTES = 8 }; // four half floats
#define LEAST_DENSITY 0.25f

// The charts, with as many luxels a unit as the knobs ask for and the memory allows.
static bool lay_out(const Frame *frame) {
    float density = frame->knobs[KNOB_DENSITY], most = 1024 * frame->knobs[KNOB_MEMORY];
    int padding = (int)frame->knobs[KNOB_PADDING];
    Atlas *atlas = &state.atlas;
    bool ok = atlas_layout(atlas, frame->scene, density, padding);
#ifdef SOLUTION // 12.12
    while (ok && LUXEL_BYTES * (float)(atlas->width * atlas->height) > most && density > LEAST_DENSITY) {
        density /= 2;
        ok = atlas_layout(atlas, frame->scene, density, padding);
    }
#else
    // TODO(12.12): while the atlas takes more than `most` bytes (LUXEL_BYTES a luxel) and the density is over
    // LEAST_DENSITY, halve the density and lay the atlas out again.
    UNUSED(most);
#endif
    return ok;
}

// The light map, before and after dilation. Its sides can be halved three times, for the mipmaps.
static bool make_light_map(void) {
    int width = (state.atlas.width + 7) / 8 * 8, height = (state.atlas.height + 7) / 8 * 8;
    GLenum format = GL_RGBA8;
#ifdef SOLUTION // 12.10
    format = GL_RGBA16F;
#else
    // TODO(12.10): near a lamp there is more light than 1, far from it less than 1/255. Take four channels of
    // 16-bit floats.
#endif
    target_destroy(&state.bare);
    target_destroy(&state.light_map);
    return target_create(&state.bare, width, height, format, 0) &&
           target_create(&state.light_map, width, height, format, 0);
}

// The last mipmap level that only mixes a chart's luxels with its own padding, and so the last one that may
// be used.
static int last_level(int padding) {
    int level = 0;
#ifdef SOLUTION // 12.11
    while (3 << (level + 1) <= 2 * (padding + 1))
        level++;
#else
    // TODO(12.11): level l needs a padding of 3/2 * 2^l - 1. The largest one that has it, and 0 at least.
    UNUSED(padding);
#endif
    return level;
}

static void set_filters(void) {
    glBindTexture(GL_TEXTURE_2D, state.light_map.color);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
#ifdef SOLUTION // 12.11
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, last_level(state.atlas.padding));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glGenerateMipmap(GL_TEXTURE_2D);
#else
    // TODO(12.11), second part: set the last level, blend linearly between levels where luxels are smaller
    // than pixels, and fill the levels from level 0. Look up: GL_TEXTURE_MAX_LEVEL, glGenerateMipmap.
    UNUSED(last_level);
#endif
}

// Pass 1: the light map, only when what stands still has changed.
static void bake(const Frame *frame) {
    Scene still = part_of_scene(frame->scene, false);
    draw_map(frame, &state.still, &still);
    if (is_baked(frame))
        return;
    state.is_baked = lay_out(frame) && make_light_map();
    if (!state.is_baked)
        return;
    if (frame->knobs[KNOB_SHADOWS] == SHADOWS_BY_RAYS)
        look_from_luxels(frame, &still, &state.atlas);
    upload_shares();
    draw_luxels(frame);
    draw_dilated(frame);
    set_filters();
}

// Pass 2: the shadow map of what moves, in every frame.
static void draw_moving(const Frame *frame) {
    Scene moving = part_of_scene(frame->scene, true);
#ifdef SOLUTION // 12.9
    draw_map(frame, &state.moving, &moving);
#else
    // TODO(12.9): draw what moves into its map. Look up: draw_map in passes.h.
    UNUSED(frame, moving);
#endif
}

// Pass 3: the picture.
static void draw_picture(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_PICTURE];
    frame_bind(frame);
    program_set_texture(program, "u_light_map", 0, GL_TEXTURE_2D, state.light_map.color);
    program_set_texture(program, "u_still", 1, GL_TEXTURE_2D, state.still.texture);
    program_set_texture(program, "u_moving", 2, GL_TEXTURE_2D, state.moving.texture);
    program_set_vec4s(program, "u_charts", state.atlas.rectangles, ATLAS_MAX_CHARTS);
    program_set_mat4(program, "u_light_clip_from_world",
                     shadow_map_clip_from_world(&frame->scene->lights[0]));
    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
}

const Lab lab = {
    .title = "Light maps",
    .programs = {[PROGRAM_DEPTH] = {"scene.vert", "empty.frag", NULL},
                 [PROGRAM_BAKE] = {"bake.vert", "bake.frag", NULL},
                 [PROGRAM_DILATE] = {"fullscreen.vert", "dilate.frag", NULL},
                 [PROGRAM_PICTURE] = {"scene.vert", "shade.frag", NULL}},
    .knobs = {[KNOB_DENSITY] = {"luxel density", "luxels per unit", 0.5f, 16, 4},
              [KNOB_PADDING] = {"padding", "luxels", 0, 8, 1},
              [KNOB_SHADOWS] = {"shadows", "", 0, 2, 1, {"none", "rays", "shadow map"}},
              [KNOB_RAYS] = {"rays", "per luxel", 1, 4096, 64},
              [KNOB_MAP_SIZE] = {"map size", "texels", 16, 2048, 512},
              [KNOB_MEMORY] = {"memory", "KiB", 1, 32768, 32768},
              [KNOB_PATTERN] = {"test pattern", "", 0, 2, 0, {"light", "stripes", "numbers"}}},
    .passes = {{"light map", bake, PASS_PREPARE},
               {"what moves", draw_moving, PASS_PREPARE},
               {"picture", draw_picture}},
    .stages = {{"shares of the lamp", &state.by_rays},
               {"bare luxels", &state.bare.color},
               {"light map", &state.light_map.color}},
    .create = create,
    .destroy = destroy,
};
