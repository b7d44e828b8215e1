// What counting costs: fragments, which are the same at each run.
#include "scene/check.h"
#include "scene/count.h"
#include "rows_counting.h"
#include "truth/closed_scenes.h"

#include <math.h>
#include <stdio.h>

enum { MAP = 512, WALK = 640, LEAST_WIDTH = 32, WIDTH = 128, MOST_WIDTH = 256 };
static const float half_map = 5;

// The lab tells how many fragments are drawn by way of its message.
#define COUNT_FRAGMENTS(draw)                                                                                \
    "    GLuint query, fragments = 0;\n"                                                                     \
    "    glGenQueries(1, &query);\n"                                                                         \
    "    glBeginQuery(GL_SAMPLES_PASSED, query);\n" draw "    glEndQuery(GL_SAMPLES_PASSED);\n"              \
    "    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &fragments);\n"                                         \
    "    glDeleteQueries(1, &query);\n"                                                                      \
    "    check_fail(\"%u fragments\", fragments);\n"

#define DRAW_VOLUMES "    casters_draw(frame, program);\n"
#define DRAW_MAP                                                                                             \
    "    draw_scene(frame, &frame->programs[PROGRAM_DEPTH], light_clip_from_world(light), "                  \
    "light->position);\n"
#define DRAW_PICTURE                                                                                         \
    "    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);\n"

static const Change volume_fragments = {
    .name = "fragments of volumes",
    .edits = {{"lab.c", DRAW_VOLUMES,
               "    {\n    glDepthFunc(GL_ALWAYS);\n" COUNT_FRAGMENTS(DRAW_VOLUMES) "    }\n"}},
    .edit_count = 1};
static const Change map_texels = {
    .name = "texels of the map", .edits = {{"lab.c", DRAW_MAP, COUNT_FRAGMENTS(DRAW_MAP)}}, .edit_count = 1};
static const Change map_lookups = {.name = "lookups in the map",
                                   .edits = {{"lab.c", DRAW_PICTURE, COUNT_FRAGMENTS(DRAW_PICTURE)}},
                                   .edit_count = 1};

// So many boxes in one place, beside the picture; their shadow crosses it before the wall.
static Scene boxes(int count) {
    Scene scene = closed_wall(6, 10, glm_rad(40));
    for (int i = 0; i < count; i++)
        closed_add(&scene, SHAPE_BOX, vec3_make(3, 0, 5), vec3_make(0.3f, 0.5f, 0.3f), 0);
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(10, 0, 3), vec3_make(0, 0, 0), 0, half_map, 1, 40);
    return scene;
}

static bool count_fragments(const Probe *probe, double *fragments) {
    static Reply reply;
    Image image = {0};
    unsigned count = 0;
    LabArtist *artist = lab_set_artist(probe->labs, probe->lab, probe->change);
    const Request request = truth_view_request(&probe->truth_view, &probe->setting);
    bool ok = artist && lab_artist_draw(artist, &request, &image, &reply) &&
              (sscanf(reply.message, "%u fragments", &count) == 1 ||
               check_fail("no fragments were counted: %s", reply.message));
    image_destroy(&image);
    *fragments = count;
    return ok;
}

// The shadow leaves the picture before the depth 8.
static bool meets_shadow(const Scene *caster, vec3s ray) {
    for (int i = 1; i <= WALK; i++)
        if (sight_holds_at(caster, ray, 8.0 * i / WALK))
            return true;
    return false;
}

// Two faces for each pixel whose ray meets the shadow.
static SightShare expect_volumes(const Probe *probe, int count) {
    static uint8_t flags[MOST_WIDTH * MOST_WIDTH];
    Scene caster = sight_casters(&probe->truth_view.truth.scene);
    MetricsSize size = probe->truth_view.size;
    caster.object_count = 1;
    INVARIANT((size_t)(size.width * size.height) <= sizeof flags);
    for (int i = 0; i < size.width * size.height; i++) {
        flags[i] = meets_shadow(&caster, sight_ray(&caster.camera, size, i % size.width, i / size.width));
        probe->measured.mask[i] = 1;
    }
    SightShare share = sight_share(probe, flags);
    return (SightShare){2 * count * share.share, 2 * count * share.tolerance};
}

// Texels of the wall and of one box, as a share of the picture: the others are as far away and fail the depth
// test. The sides of both may lie half a texel elsewhere.
static SightShare expect_texels(const Probe *probe, int count) {
    const double x = 10 / sqrt(109), z = 3 / sqrt(109), texel = 2 * half_map / MAP, wall = 12 * z,
                 box = 4 * (0.3 * 0.5 * z + 0.5 * 0.3 * x), length = 2 * half_map,
                 outline = 2 * length + 4 * (0.3 * z + 0.3 * x + 0.5);
    double pixels = probe->truth_view.size.width * probe->truth_view.size.height;
    (void)count;
    return (SightShare){(wall * length + box) / (texel * texel) / pixels, outline / 2 / texel / pixels};
}

// The wall fills the picture.
static SightShare expect_lookups(const Probe *probe, int count) {
    (void)probe, (void)count;
    return (SightShare){1, 0};
}

// A kind of fragment.
typedef struct Fill {
    const char *name, *lab;
    const Change *change;
    SightShare (*expect)(const Probe *probe, int count); // a pixel of the picture
} Fill;

static const Fill fills[] = {{"fragments of volumes", LAB_ID, &volume_fragments, expect_volumes},
                             {"texels of the map", "03", &map_texels, expect_texels},
                             {"lookups in the map", "03", &map_lookups, expect_lookups}};
enum { FILL_COUNT = COUNT(fills) };

// Adds a point at x, in fragments a pixel, or in fragments for x = the picture's width.
static bool add_point(LabSet *labs, const Fill *fill, Curve *curve, int count, int width, bool by_width) {
    const Scene scene = boxes(count);
    Probe probe;
    double fragments, pixels = (double)width * width;
    bool ok = probe_begin(&probe, labs, fill->lab, &scene, width, width);
    if (fill->lab[1] == '3')
        probe_knob(&probe, "map size", MAP);
    ok = ok && probe_draw(&probe);
    probe.change = fill->change;
    ok = ok && count_fragments(&probe, &fragments);
    if (ok) {
        SightShare share = fill->expect(&probe, count);
        double unit = by_width ? pixels : 1;
        curve_add(curve, by_width ? width : count, fragments / pixels * unit, share.share * unit,
                  share.tolerance * unit);
    }
    probe_end(&probe);
    return ok;
}

static bool run_fill(LabSet *labs, Findings *findings) {
    Figure *by_count = findings_figure(findings, "More volumes", "volumes", "fragments a pixel"),
           *by_width = findings_figure(findings, "A larger picture", "width (pixels)", "fragments");
    by_width->log_x = by_width->log_y = true;
    const int some[] = {1, 2, 3, 5, 8};
    bool ok = true;
    for (int f = 0; ok && f < FILL_COUNT; f++) {
        Curve *counts = figure_curve(by_count, fills[f].name, CURVE_EQUAL),
              *widths = figure_curve(by_width, fills[f].name, CURVE_EQUAL);
        for (size_t i = 0; ok && i < COUNT(some); i++)
            ok = add_point(labs, &fills[f], counts, some[i], WIDTH, false);
        for (int width = LEAST_WIDTH; ok && width <= MOST_WIDTH; width *= 2)
            ok = add_point(labs, &fills[f], widths, 4, width, true);
    }
    return ok;
}

const Row LAB_TABLE[] = {
    {27, "fill", "shadow volumes, shadow map", "1 to 8 volumes; pictures 32 to 256 pixels wide",
     "Each volume draws two faces over all that it covers, in front of surfaces or behind them: fragments "
     "grow "
     "with the number of volumes and with the picture. The texels of a map do neither (what lies behind "
     "fails "
     "the depth test), and each pixel looks the map up once. Times stand in the chart; here counts do, the "
     "same at each run.",
     "closed form: rays that meet the volume, twice; areas of wall and box", run_fill},
    {0},
};
