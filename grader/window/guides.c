// Draws the guides into a framebuffer of their own: the picture, under it the scene's depth, over it haze,
// the borders of texels, and lines.
#include "window/guides.h"

#include "casters.h"
#include "caster_volumes.h"
#include "draw.h"
#include "scene/check.h"
#include "shadow_map.h"
#include "window/guide_lines.h"
#include "window/screen.h"

#include <string.h>

static const vec3s reddish = {{1, 0.35F, 0.25F}}, bluish = {{0.3F, 0.5F, 1}};
static const vec3s light_tints[SCENE_MAX_LIGHTS] = {
    {{1, 0.85F, 0.2F}}, {{0.3F, 1, 0.5F}}, {{0.3F, 0.85F, 1}}, {{1, 0.5F, 1}}};

static bool create(Guides *guides) {
    guides->created = true;
    glGenTextures(1, &guides->texture);
    glGenVertexArrays(1, &guides->array);
    glGenBuffers(1, &guides->buffer);
    glBindVertexArray(guides->array);
    glBindBuffer(GL_ARRAY_BUFFER, guides->buffer);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(vec3s), NULL);
    return draw_create() && casters_create() &&
           program_create(&guides->depth, &(ProgramFiles){"scene.vert", "empty.frag", NULL}) &&
           program_create(&guides->haze, &(ProgramFiles){"volume.vert", "guide.frag", NULL}) &&
           program_create(&guides->lines, &(ProgramFiles){"guide.vert", "guide.frag", NULL}) &&
           program_create(&guides->texels, &(ProgramFiles){"scene.vert", "texels.frag", NULL}) &&
           program_create(&guides->copy, &(ProgramFiles){"fullscreen.vert", "picture.frag", NULL});
}

void guides_destroy(Guides *guides) {
    Program *programs[] = {&guides->depth, &guides->haze, &guides->lines, &guides->texels, &guides->copy};
    if (!guides->created)
        return;
    for (int i = 0; i < 5; i++)
        program_destroy(programs[i]);
    glDeleteTextures(1, &guides->texture);
    glDeleteVertexArrays(1, &guides->array);
    glDeleteBuffers(1, &guides->buffer);
    target_destroy(&guides->target);
    casters_destroy();
    draw_destroy();
    memset(guides, 0, sizeof *guides);
}

static void set_tint(const Program *program, vec3s tint, float share) {
    program_set_vec3(program, "u_tint", tint);
    program_set_float(program, "u_share", share);
}

// The picture as it is, and the depth of the scene behind it.
static void begin(const Guides *guides, const Frame *frame, const Image *picture) {
    target_bind(&guides->target);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    screen_fill(guides->texture, picture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    program_set_texture(&guides->copy, "u_picture", 0, GL_TEXTURE_2D, guides->texture);
    program_set_vec4s(&guides->copy, "u_part", &(vec4s){{0, 0, 1, 1}}, 1);
    draw_fullscreen(&guides->copy);
    glClearDepth(1);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw_scene(frame, &guides->depth, frame_clip_from_world(frame), frame->scene->camera.eye);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

static void end(void) {
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_CULL_FACE);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDepthMask(GL_TRUE);
    glBindFramebuffer(GL_FRAMEBUFFER, SCREEN_FRAMEBUFFER);
}

// Faces of the volumes before what is seen, near caps pushed back behind the faces on which they lie: as the
// stage "haze" of frame_view.h, for each light.
static void draw_volumes(const Guides *guides, const Frame *frame) {
    static Scene scene;
    Frame by_light = *frame;
    scene = *frame->scene;
    by_light.scene = &scene;
    glEnable(GL_DEPTH_CLAMP);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0, 16);
    for (int i = 0; i < frame->scene->light_count; i++) {
        scene.lights[0] = frame->scene->lights[i];
        for (int back = 0; back < 2; back++) {
            glCullFace(back ? GL_FRONT : GL_BACK);
            set_tint(&guides->haze, back ? bluish : reddish, 0.22F);
            draw_begin(&by_light, &guides->haze, frame_clip_from_world(frame), scene.camera.eye);
            casters_draw_volumes(&by_light);
        }
    }
    glCullFace(GL_BACK);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_CLAMP);
}

static void draw_texels(const Guides *guides, const Frame *frame, int i, float map_size) {
    const Light *light = &frame->scene->lights[i];
    const Program *program = &guides->texels;
    const bool is_parallel = light->kind == LIGHT_DIRECTIONAL;
    const vec3s along = glms_vec3_sub(light->target, light->position);
    if (light->kind == LIGHT_POINT) // six maps, of no one grid
        return;
    program_set_mat4(program, "u_map_clip_from_world", shadow_map_clip_from_world(light));
    program_set_vec3(program, "u_map_position_world", light->position);
    program_set_vec3(program, "u_map_direction", is_parallel ? along : vec3_make(0, 0, 0));
    program_set_float(program, "u_map_size", map_size);
    program_set_vec3(program, "u_tint", light_tints[i]);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0, -16);
    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

// What is hidden by the scene shows faintly.
static void draw_lines(const Guides *guides, const Frame *frame, int i) {
    GuideLines lines = {.count = 0};
    guide_lines_add(&lines, &frame->scene->lights[i]);
    program_set_mat4(&guides->lines, "u_clip_from_world", frame_clip_from_world(frame));
    glUseProgram(guides->lines.id);
    glBindVertexArray(guides->array);
    glBindBuffer(GL_ARRAY_BUFFER, guides->buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)((size_t)lines.count * sizeof *lines.ends), lines.ends,
                 GL_STREAM_DRAW);
    glEnable(GL_DEPTH_CLAMP);
    for (int hidden = 0; hidden < 2; hidden++) {
        glDepthFunc(hidden ? GL_GEQUAL : GL_LESS);
        set_tint(&guides->lines, light_tints[i], hidden ? 0.3F : 1);
        glDrawArrays(GL_LINES, 0, lines.count);
    }
    glDisable(GL_DEPTH_CLAMP);
    glDepthFunc(GL_LESS);
    glBindVertexArray(0);
}

static bool ensure(Guides *guides, const Image *picture) {
    const Target *target = &guides->target;
    if (!guides->created && !create(guides))
        return false;
    if (target->framebuffer && target->width == picture->width && target->height == picture->height)
        return true;
    target_destroy(&guides->target);
    return target_create(&guides->target, picture->width, picture->height, GL_RGBA8, GL_DEPTH_COMPONENT24);
}

static void read_back(Image *picture) {
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    for (int y = 0; y < picture->height; y++)
        glReadPixels(0, picture->height - 1 - y, picture->width, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                     picture->rgba + image_at(picture, 0, y));
}

bool guides_draw(Guides *guides, const GuideWish *wish, const Request *request, Image *picture) {
    if (!ensure(guides, picture))
        return false;
    const Frame frame = {.scene = &request->scene,
                         .framebuffer = guides->target.framebuffer,
                         .width = picture->width,
                         .height = picture->height,
                         .view = request->view};
    begin(guides, &frame, picture);
    if (wish->volumes)
        draw_volumes(guides, &frame);
    for (int i = 0; wish->light != LIGHT_HIDDEN && i < request->scene.light_count; i++) {
        if (wish->light == LIGHT_TEXELS && wish->map_size > 0)
            draw_texels(guides, &frame, i, wish->map_size);
        draw_lines(guides, &frame, i);
    }
    read_back(picture);
    end();
    return true;
}
