// How far eight bits of stencil count.
#include "scene/check.h"
#include "rows_counting.h"
#include "truth/closed_scenes.h"

#include <math.h>
#include <stdlib.h>

enum { SIZE = COUNTING_SIZE, BITS = 256, WALK = 200, ORDERS = 3 };

// A scene has 16 objects at most, so each volume is drawn many times, up to 32 by one call. The planes of
// light 0, which volumes do not use, say how: the number of copies and the order, 0: as they come, 1: all
// front faces first (in z-pass they add one), 2: all back faces first.
#define COPIES                                                                                               \
    {"lab.c", "    casters_draw(frame, program);\n",                                                         \
     "    {\n"                                                                                               \
     "    int copies = (int)frame->scene->lights[0].near_plane;\n"                                           \
     "    int order = (int)frame->scene->lights[0].far_plane;\n"                                             \
     "    for (int half = 0; half < (order ? 2 : 1); half++) {\n"                                            \
     "        if (order)\n"                                                                                  \
     "            glEnable(GL_CULL_FACE);\n"                                                                 \
     "        glCullFace((half == 0) == (order == 1) ? GL_BACK : GL_FRONT);\n"                               \
     "        for (int left = copies; left > 0; left -= 32) {\n"                                             \
     "            program_set_int(program, \"u_copies\", left < 32 ? left : 32);\n"                          \
     "            casters_draw(frame, program);\n"                                                           \
     "        }\n"                                                                                           \
     "    }\n"                                                                                               \
     "    glCullFace(GL_BACK);\n"                                                                            \
     "    glDisable(GL_CULL_FACE);\n"                                                                        \
     "    }\n"},                                                                                             \
        {"volume.geom", "layout(triangles_adjacency) in;",                                                   \
         "layout(triangles_adjacency, invocations = 32) in;\nuniform int u_copies;"},                        \
    {                                                                                                        \
        "volume.geom", "void main() {\n",                                                                    \
            "void main() {\n    if (gl_InvocationID >= u_copies)\n        return;\n"                         \
    }

static const Change wrapping = {.name = "many copies", .edits = {COPIES}, .edit_count = 3};

static const Change saturating = {
    .name = "many copies, without wrapping",
    .edits = {COPIES,
              {"lab.c", "GL_KEEP, GL_KEEP, GL_INCR_WRAP", "GL_KEEP, GL_KEEP, GL_INCR"},
              {"lab.c", "GL_KEEP, GL_KEEP, GL_DECR_WRAP", "GL_KEEP, GL_KEEP, GL_DECR"}},
    .edit_count = 5};

// Two plates under slanting light: the shadow of the nearer one crosses the way to that of the other.
static Scene two_plates(int copies, int order) {
    Scene scene = closed_wall(6, 10, glm_rad(40));
    closed_add(&scene, SHAPE_BOX, vec3_make(1.8f, 0, 1.2f), vec3_make(0.4f, 1.2f, 0.05f), 0);
    closed_add(&scene, SHAPE_BOX, vec3_make(2.6f, 0, 4.2f), vec3_make(0.4f, 0.5f, 0.05f), 0);
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(10, 0, 6), vec3_make(0, 0, 0), 0, 10, (float)copies,
                 (float)order);
    return scene;
}

// How often a pixel's way to the wall goes into and out of the two volumes.
typedef struct Way {
    uint8_t in, out;
} Way;

static void find_ways(const Probe *probe, Way *ways) {
    Scene both = sight_casters(&probe->truth_view.truth.scene), one = both;
    one.object_count = 1;
    for (int i = 0; i < SIZE * SIZE; i++) {
        const TruthHit *hit = &probe->truth_view.picture.hits[i];
        ways[i] = (Way){0};
        for (int caster = 0; hit->object == 0 && caster < 2; caster++) {
            one.objects[0] = both.objects[caster];
            vec3s end = glms_vec3_lerp(both.camera.eye, hit->position, 0.9999f);
            int in = sight_enters(&one, both.camera.eye, end, WALK);
            ways[i].in += (uint8_t)in;
            ways[i].out += (uint8_t)(in - sight_holds(&one, end));
        }
    }
}

// The stencil's value after so many copies.
static int wrapped(Way way, int copies, int order) {
    (void)order;
    return ((way.in - way.out) * copies % BITS + BITS) % BITS;
}

static int saturated(Way way, int copies, int order) {
    int in = way.in * copies, out = way.out * copies, most = BITS - 1;
    if (order == 1)
        return (in < most ? in : most) > out ? (in < most ? in : most) - out : 0;
    return in < most ? in : most; // the back faces came first and found nothing to take away
}

typedef int (*CountOf)(Way way, int copies, int order);

// Which pixels are wrong: those of no volume with a count, and the others with none.
static SightShare wrong_counts(const Probe *probe, const Way *ways, int copies, int order, CountOf count) {
    static uint8_t flags[SIZE * SIZE];
    for (int i = 0; i < SIZE * SIZE; i++)
        flags[i] = (count(ways[i], copies, order) != 0) != (ways[i].in > ways[i].out);
    return sight_share(probe, flags);
}

// Of the plates themselves nothing is asked.
static bool sweep_copies(const Counting *method, const Way *ways, int order, CountOf count) {
    bool ok = true;
    for (int copies = 250; ok && copies <= 260; copies++) {
        const Scene scene = two_plates(copies, order);
        Probe probe;
        ok = probe_begin(&probe, method->labs, LAB_ID, &scene, SIZE, SIZE);
        probe.change = method->change;
        probe.setting.object = 0;
        probe_knob(&probe, "method", Z_PASS);
        ok = ok && probe_draw(&probe);
        if (ok)
            counting_add(method, &probe, copies, wrong_counts(&probe, ways, copies, order, count), 0);
        probe_end(&probe);
    }
    return ok;
}

static bool run_stencil(LabSet *labs, Findings *findings) {
    static const char *const orders[ORDERS] = {"as they come", "front faces first", "back faces first"},
                             *const lost[ORDERS] = {"", "failure: front faces first",
                                                    "failure: back faces first"};
    static Way ways[SIZE * SIZE];
    Figure *wraps =
               findings_figure(findings, "Counts that wrap", "volumes in each other", "wrong pixels (share)"),
           *stops = findings_figure(findings, "Counts that stop at 0 and 255", "volumes in each other",
                                    "wrong pixels (share)");
    const Scene scene = two_plates(1, 0);
    Probe probe;
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, SIZE, SIZE);
    if (ok)
        find_ways(&probe, ways);
    probe_end(&probe);
    for (int order = 0; ok && order < ORDERS; order++)
        ok = sweep_copies(&(Counting){labs, findings, figure_curve(wraps, orders[order], CURVE_EQUAL),
                                      &wrapping, Z_PASS, 0},
                          ways, order, wrapped);
    for (int order = 1; ok && order < ORDERS; order++)
        ok = sweep_copies(&(Counting){labs, findings, figure_curve(stops, lost[order], CURVE_EQUAL),
                                      &saturating, Z_PASS, order},
                          ways, order, saturated);
    return ok;
}

const Row LAB_TABLE[] = {
    {26, "eight bits of stencil", "z-pass", "250 to 260 copies of two volumes, in three orders",
     "Counts that wrap are right in any order but for 256 volumes, which count as none. Counts that stop at "
     "0 and "
     "255 depend on the order: with the front faces first, a shadow behind 255 volumes or more is lost; with "
     "the "
     "back faces first, what lies behind any volume is dark.",
     "count along each pixel's ray", run_stencil},
    {0},
};
