// Lab 08: ambient occlusion. How much of the sky is hidden: by rays, and from the picture alone.
#include "atlas.h"
#include "geometry.h"
#include "lab.h"
#include "ray.h"
#include "samples.h"

enum { KNOB_DENSITY, KNOB_PADDING, KNOB_RAYS, KNOB_RAY_LENGTH, KNOB_METHOD, KNOB_PATTERN };
enum { PROGRAM_GEOMETRY, PROGRAM_SCREEN, PROGRAM_PICTURE };

static struct {
    Atlas atlas;             // on our side: charts and texels
    GLuint texture;          // on OpenGL's side: the same texels
    Target geometry, screen; // for the screen-space method
} state;

// Direction of a ray, in the world, from two numbers in [0, 1) x [0, 1).
static vec3s cosine_direction(const Chart *chart, vec2s pair) {
#ifdef SOLUTION // 8.7
    float radius = sqrtf(pair.x), angle = 2 * (float)GLM_PI * pair.y;
    vec3s right = glms_vec3_scale(chart->right, radius * cosf(angle));
    vec3s up = glms_vec3_scale(chart->up, radius * sinf(angle));
    vec3s normal = glms_vec3_scale(chart->normal, sqrtf(1 - pair.x));
    return glms_vec3_add(glms_vec3_add(right, up), normal);
#else
    // TODO(8.7): a point of the unit disc, at radius r = sqrt(pair.x) and angle 2 pi pair.y, lifted onto the
    // hemisphere: x = r cos, y = r sin, z = sqrt(1 - pair.x). In the world: x right + y up + z normal.
    UNUSED(pair);
    return chart->normal;
#endif
}

// Share of the rays from this place that hit something. The texel's number is the seed of its rays.
static float occlusion_at(const Frame *frame, const Chart *chart, vec3s position, int texel) {
    int rays = (int)frame->knobs[KNOB_RAYS], hits = 0;
#ifdef SOLUTION // 8.6
    vec3s origin = glms_vec3_add(position, glms_vec3_scale(chart->normal, RAY_OFFSET));
    for (int i = 0; i < rays; i++) {
        vec3s direction = cosine_direction(chart, sample_pair((uint64_t)texel, i, rays));
        hits += ray_hits(frame->scene, origin, direction, frame->knobs[KNOB_RAY_LENGTH]);
    }
#else
    // TODO(8.6): from RAY_OFFSET above the place, along the normal, cast `rays` rays as long as the knob
    // says, the i-th in the direction that sample_pair(texel, i, rays) gives. Count hits. Look up: ray_hits.
    UNUSED(chart, position, texel, cosine_direction);
#endif
    return (float)hits / (float)rays;
}

static float bake_at(const Frame *frame, const Chart *chart, vec3s position, int texel) {
    if (frame->knobs[KNOB_PATTERN] > 0) // stripes that show where each texel lies
        return 0.5f + 0.5f * sinf(3 * position.x + 4 * position.y + 5 * position.z);
    return occlusion_at(frame, chart, position, texel);
}

static void fill_chart(const Frame *frame, Atlas *atlas, const Chart *chart) {
#ifdef SOLUTION // 8.2
    for (int y = 0; y < chart->height; y++)
        for (int x = 0; x < chart->width; x++) {
            float s = ((float)x + 0.5f) / (float)chart->width, t = ((float)y + 0.5f) / (float)chart->height;
            int texel = (chart->bottom + y) * atlas->width + chart->left + x;
            atlas->texels[texel] = bake_at(frame, chart, atlas_position(chart, s, t), texel);
        }
#else
    // TODO(8.2): give texel (x, y) of the chart bake_at of its middle: s = (x + 1/2) / width, t likewise. Its
    // number is row * atlas->width + column, counted in the atlas. Look up: atlas_position, Chart.
    UNUSED(frame, atlas, chart, bake_at);
#endif
}

static void pad_chart(Atlas *atlas, const Chart *chart) {
#ifdef SOLUTION // 8.5
    for (int y = -atlas->padding; y < chart->height + atlas->padding; y++)
        for (int x = -atlas->padding; x < chart->width + atlas->padding; x++) {
            int from_x = chart->left + (x < 0 ? 0 : x < chart->width ? x : chart->width - 1);
            int from_y = chart->bottom + (y < 0 ? 0 : y < chart->height ? y : chart->height - 1);
            int to = (chart->bottom + y) * atlas->width + chart->left + x;
            atlas->texels[to] = atlas->texels[from_y * atlas->width + from_x];
        }
#else
    // TODO(8.5): give each texel of the padding (x from -padding to width + padding - 1, y likewise) the
    // value of the chart's texel nearest to it: x limited to 0 .. width - 1, y to 0 .. height - 1.
    UNUSED(atlas, chart);
#endif
}

static void bake(const Frame *frame) {
    Atlas *atlas = &state.atlas;
    if (frame->knobs[KNOB_METHOD] > 0 ||
        !atlas_layout(atlas, frame->scene, frame->knobs[KNOB_DENSITY], (int)frame->knobs[KNOB_PADDING]))
        return;
    for (int c = 0; c < atlas->chart_count; c++) {
        fill_chart(frame, atlas, &atlas->charts[c]);
        pad_chart(atlas, &atlas->charts[c]);
    }
    if (frame->knobs[KNOB_PATTERN] > 1)
        atlas_number_texels(atlas);
    glBindTexture(GL_TEXTURE_2D, state.texture);
#ifdef SOLUTION // 8.1
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, atlas->width, atlas->height, 0, GL_RED, GL_FLOAT, atlas->texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
#else
    // TODO(8.1): give the texture the size and the texels of the atlas, one float each (GL_R32F, GL_RED,
    // GL_FLOAT), and linear filters without mipmaps. Look up: glTexImage2D, glTexParameteri.
#endif
}

static bool create(const Frame *frame) {
    state.texture = gl_create_grey_texture();
    return geometry_create(&state.geometry, frame) &&
           target_create(&state.screen, frame->width, frame->height, GL_RGBA8, 0);
}

static void destroy(void) {
    glDeleteTextures(1, &state.texture);
    state.texture = 0;
    target_destroy(&state.geometry);
    target_destroy(&state.screen);
    atlas_destroy(&state.atlas);
}

static void draw_screen_occlusion(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_SCREEN];
    if (frame->knobs[KNOB_METHOD] <= 0)
        return;
    geometry_draw(&state.geometry, frame, &frame->programs[PROGRAM_GEOMETRY]);
    target_bind(&state.screen);
    geometry_use(&state.geometry, frame, program);
    program_set_float(program, "u_radius", frame->knobs[KNOB_RAY_LENGTH]);
    draw_fullscreen(program);
}

static void draw_picture(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_PICTURE];
    frame_bind(frame);
    program_set_texture(program, "u_baked", 0, GL_TEXTURE_2D, state.texture);
    program_set_texture(program, "u_screen", 1, GL_TEXTURE_2D, state.screen.color);
    program_set_int(program, "u_use_screen", frame->knobs[KNOB_METHOD] > 0);
    program_set_vec4s(program, "u_charts", state.atlas.rectangles, ATLAS_MAX_CHARTS);
    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
}

const Lab lab = {
    .title = "Ambient occlusion",
    .programs = {[PROGRAM_GEOMETRY] = {"scene.vert", "geometry.frag", NULL},
                 [PROGRAM_SCREEN] = {"fullscreen.vert", "ssao.frag", NULL},
                 [PROGRAM_PICTURE] = {"scene.vert", "occlusion.frag", NULL}},
    .knobs = {[KNOB_DENSITY] = {"texel density", "texels per unit", 1, 16, 4},
              [KNOB_PADDING] = {"padding", "texels", 0, 4, 1},
              [KNOB_RAYS] = {"rays", "per texel", 1, 4096, 64},
              [KNOB_RAY_LENGTH] = {"ray length", "world units", 0.1f, 100, 100},
              [KNOB_METHOD] = {"method", "", 0, 1, 0, {"baked", "screen space"}},
              [KNOB_PATTERN] = {"test pattern", "", 0, 2, 0, {"rays", "stripes", "texels"}}},
    .passes = {{"bake", bake, PASS_PREPARE},
               {"screen occlusion", draw_screen_occlusion, PASS_PREPARE},
               {"picture", draw_picture}},
    .stages = {{"baked occlusion", &state.texture}, {"screen occlusion", &state.screen.color}},
    .create = create,
    .destroy = destroy,
};
