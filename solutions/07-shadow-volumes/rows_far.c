// Where shadows are far from the world's origin, and where the lamp stands in its caster.
#include "scene/count.h"
#include "truth/closed_scenes.h"
#include "stability/probe.h"
#include "stability/row.h"

#include <math.h>
#include <string.h>

enum { SIDE = 160, MAP = 512 };

// Whose shadows: a lab, and its choice of silhouettes or method.
typedef struct Way {
    const char *name, *lab, *knob;
    double value;
} Way;

static const Way ways[] = {{"hard map (lab 05)", "05", "method", 1},
                           {"z-fail, geometry shader", "07", "silhouettes", 0},
                           {"z-fail, sides found on the CPU", "07", "silhouettes", 1}};

static void move(Scene *scene, vec3s by) {
    for (int i = 0; i < scene->object_count; i++) {
        mat4s *placed = &scene->objects[i].world_from_object;
        const vec3s old = vec3_make(placed->raw[3][0], placed->raw[3][1], placed->raw[3][2]);
        const vec3s now = glms_vec3_add(old, by);
        placed->raw[3][0] = now.x;
        placed->raw[3][1] = now.y;
        placed->raw[3][2] = now.z;
    }
    scene->lights[0].position = glms_vec3_add(scene->lights[0].position, by);
    scene->lights[0].target = glms_vec3_add(scene->lights[0].target, by);
    scene->camera.eye = glms_vec3_add(scene->camera.eye, by);
    scene->camera.target = glms_vec3_add(scene->camera.target, by);
}

// A wall, a turned box and a ball before it, and a lamp; `far` away along x and z.
static Scene far_scene(float far) {
    Scene scene = closed_wall(6, 10, glm_rad(30));
    closed_add(&scene, SHAPE_BOX, vec3_make(-1, 0.3f, 1.2f), vec3_make(0.4f, 0.6f, 0.3f), 25);
    closed_add(&scene, SHAPE_SPHERE, vec3_make(0.6f, -0.5f, 1.5f), vec3_make(0.5f, 0.5f, 0.5f), 0);
    closed_light(&scene, LIGHT_SPOT, vec3_make(1, 1.5f, 7), vec3_make(0, 0, 0), glm_rad(70), 0, 2, 12);
    move(&scene, vec3_make(far, 0, far));
    return scene;
}

static bool measure(LabSet *labs, Findings *findings, int slot, const Way *way, const Scene *scene,
                    double *error) {
    Probe probe;
    bool ok = probe_begin(&probe, labs, way->lab, scene, SIDE, SIDE);
    probe_knob(&probe, way->knob, way->value);
    if (strcmp(way->lab, "05") == 0)
        probe_knob(&probe, "map size", MAP);
    ok = ok && probe_draw(&probe);
    *error = probe.measured.metrics.interior.mae;
    if (ok)
        findings_frame(findings, slot, *error, &probe.truth_view, &probe.measured, "%s, the eye at x = %g",
                       way->name, (double)scene->camera.eye.x);
    probe_end(&probe);
    return ok;
}

// Numbers of this size are multiples of this.
static double float_step(double size) {
    return size / (1 << 23);
}

static const double unit = 2 * 10 * 0.26795 / SIDE; // world units of the wall a pixel: tan 15 degrees
static const double outline = 7;                    // of the two shadows, world units, at least

// Four numbers are rounded between an object's place and its picture, each by half a step: pixels as near as
// that to an outline may change, and four pixels more.
static double far_tolerance(double far) {
    return (4 * float_step(far) / 2 * outline / unit / unit + 4) / (SIDE * SIDE);
}

static const vec3s none = {{0, 0, 0}};

// One way from near to far; `home`: the eye is brought back to the origin, and all with it, before anything
// is drawn.
static bool sweep_far(LabSet *labs, Findings *findings, Curve *curve, Curve *failure, const Way *way,
                      bool home) {
    double error;
    bool ok = true;
    for (int i = 0; ok && i <= 6; i++) {
        const float far = powf(10, (float)i);
        Scene scene = far_scene(far);
        if (home)
            move(&scene, glms_vec3_sub(none, scene.camera.eye));
        ok = measure(labs, findings, home ? 1 : 0, way, &scene, &error);
        if (home || i <= 4)
            curve_add(curve, (double)far, error, 0, far_tolerance(home ? 0 : (double)far));
        else if (i == 6)
            curve_add(failure, way - ways, error, outline * float_step(1e6) / (SIDE * SIDE * unit * unit), 0);
    }
    return ok;
}

static bool run_far(LabSet *labs, Findings *findings) {
    static const char away[] = "distance along x and z (world units)";
    Figure *figure = findings_figure(findings, "Far from the origin", away, "error inside (share)"),
           *lost = findings_figure(findings, "A million away", "way, in the order of the curves",
                                   "error inside (share)"),
           *back = findings_figure(findings, "As far, but moved to the eye before it is drawn", away,
                                   "error inside (share)");
    Curve *failure = figure_curve(lost, "failure: all of them", CURVE_LEAST);
    bool ok = true;
    figure->log_x = true;
    for (unsigned i = 0; ok && i < COUNT(ways); i++)
        ok = sweep_far(labs, findings, figure_curve(figure, ways[i].name, CURVE_EQUAL), failure, &ways[i],
                       false);
    for (unsigned i = 0; ok && i < COUNT(ways); i++)
        ok =
            sweep_far(labs, findings, figure_curve(back, ways[i].name, CURVE_EQUAL), failure, &ways[i], true);
    return ok;
}

// A lamp in the middle of a closed box over a wall: nothing outside is lit. The lamp's near plane is at `cut`
// half sides of the box.
static Scene lantern(double cut) {
    const float side = 0.5f;
    Scene scene = closed_wall(2, 10, (float)(2 * atan(0.19)));
    closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, 3), vec3_make(side, side, side), 0);
    closed_light(&scene, LIGHT_SPOT, vec3_make(0, 0, 3), vec3_make(0, 0, 0), glm_rad(90), 0,
                 (float)cut * side, 12);
    return scene;
}

static const Change both_faces = {
    .name = "both faces are drawn into the map",
    .edits = {{"lab.c", "    glPolygonOffset(2, 4);\n",
               "    glPolygonOffset(2, 4);\n    glDisable(GL_CULL_FACE);\n"},
              {"lab.c", "    glDisable(GL_POLYGON_OFFSET_FILL);\n",
               "    glDisable(GL_POLYGON_OFFSET_FILL);\n    glEnable(GL_CULL_FACE);\n"}},
    .edit_count = 2};

typedef struct Lantern {
    const char *name, *lab;
    const Change *change;
    bool dark_until_cut; // what the method shows before the near plane passes the box's side; after it, light
} Lantern;

static const Lantern lanterns[] = {{"failure: z-fail", "07", NULL, false},
                                   {"failure: shadow map", "03", NULL, false},
                                   {"remedy: both faces in the map", "03", &both_faces, true}};

static bool sweep_lantern(LabSet *labs, Findings *findings, Curve *curve, const Lantern *lantern_way) {
    static const double cuts[] = {0.1, 0.3, 0.6, 0.9, 1.1, 1.5, 3};
    bool ok = true;
    for (unsigned i = 0; ok && i < COUNT(cuts); i++) {
        const Scene scene = lantern(cuts[i]);
        Probe probe;
        ok = probe_begin(&probe, labs, lantern_way->lab, &scene, SIDE, SIDE);
        probe.change = lantern_way->change;
        probe.setting.object = 0;
        ok = ok && probe_draw(&probe);
        if (ok) {
            const double light = probe_false(&probe, 0, 1);
            curve_add(curve, cuts[i], light, lantern_way->dark_until_cut && cuts[i] < 1 ? 0 : 1, 0);
            findings_frame(findings, 0, light, &probe.truth_view, &probe.measured,
                           "%s, the near plane at %g half sides", lantern_way->name, cuts[i]);
        }
        probe_end(&probe);
    }
    return ok;
}

static bool run_lantern(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "A lamp in a closed box", "near plane (half sides of the box)",
                                     "false light (share of the wall)");
    bool ok = true;
    for (unsigned i = 0; ok && i < COUNT(lanterns); i++)
        ok = sweep_lantern(labs, findings, figure_curve(figure, lanterns[i].name, CURVE_EQUAL), &lanterns[i]);
    return ok;
}

const Row LAB_TABLE[] = {
    {45, "far from the origin", "hard map, z-fail",
     "the whole scene, 10 to 1,000,000 from the world's origin",
     "A float of the size D is a multiple of D / 2^23. Four numbers are rounded between a place and its "
     "picture: "
     "outlines move by two such steps at most, and to 10,000 nothing else changes, since silhouettes are "
     "found "
     "from the caster's own place. A million away a step is an eighth of a unit and all ways are wrong by at "
     "least a step along the outlines. Moved to the eye before they are drawn, all are as near the origin.",
     "IEEE 754, single precision", run_far},
    {46, "lamp in a caster", "z-fail, shadow map",
     "the lamp's near plane, 0.1 to 3 half sides of the box around it",
     "In truth nothing outside a closed box is lit. But all of its faces look away from a lamp inside: no "
     "face "
     "begins a volume, and the map leaves back faces out, so all of the wall is lit. With both faces in the "
     "map "
     "it is dark as long as the near plane stays within the box.",
     "closed form", run_lantern},
    {0},
};
