// Maps on a grid of whole texels: still under a camera that moves, and not under a sun that turns.
#include "scene/check.h"
#include "stability/probe.h"
#include "stability/row.h"
#include "truth/closed_scenes.h"

#include <stdlib.h>

// The wall is seen straight on, 10 before the camera; the picture shows 7 units by 1. The shadow's edge rises
// by a texel in 16, so that all phases between edge and grid occur equally often.
enum { WIDE = 896, HIGH = 128, RISE = 16, MAP = 64, STEPS = 8 };
static const double board_height = 12, unit = 1.0 / HIGH;

// The texel of the one slice's map, from the smallest sphere of a view from 9 to 11 (the handout's formulas).
static double texel(void) {
    const double k = 0.05 * hypot(1, (double)WIDE / HIGH), n = 9, f = 11;
    const double centre = fmin((f + n) * (1 + k * k) / 2, f);
    return 2 * hypot(f - centre, f * k) / (MAP - 2);
}

// A camera moved up by `moved`; a sun that looks straight at the wall, turned upwards by `turned`. The board
// is out of sight behind the camera.
static Scene edge_scene(double moved, double turned) {
    Scene scene = closed_wall(8, 10, 2 * atanf(0.05f));
    scene.camera.eye.y = scene.camera.target.y = (float)moved;
    scene.camera.near_plane = 9;
    scene.camera.far_plane = 11;
    closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, (float)board_height), vec3_make(1, 1, 1), 0);
    mat4s placed = glms_rotate(scene.objects[1].world_from_object, atanf(1.0f / RISE), vec3_make(0, 0, 1));
    scene.objects[1].world_from_object =
        glms_scale(glms_translate(placed, vec3_make(0, -3, 0)), vec3_make(7, 3, 1e-4f));
    closed_light(&scene, LIGHT_DIRECTIONAL,
                 vec3_make(0, (float)(20 * sin(turned)), (float)(20 * cos(turned))), vec3_make(0, 0, 0), 0, 8,
                 1, 30);
    return scene;
}

// How many pixels are lit in each column of the picture; *truth: in the mean, by rays.
static bool draw(LabSet *labs, Findings *findings, const Scene *scene, bool snapped, double lit[WIDE],
                 double *truth) {
    Probe probe;
    bool ok = probe_begin(&probe, labs, LAB_ID, scene, WIDE, HIGH);
    probe_knob(&probe, "slices", 1);
    probe_knob(&probe, "map size", MAP);
    probe_knob(&probe, "snap", snapped);
    ok = ok && probe_draw(&probe);
    *truth = 0;
    for (int i = 0; ok && i < WIDE * HIGH; i++) {
        lit[i % WIDE] = (i < WIDE ? 0 : lit[i % WIDE]) + (double)probe.measured.visibility[i];
        *truth += (double)probe.truth_view.visibility[i] / WIDE;
    }
    if (ok)
        findings_frame(findings, 0, *truth, &probe.truth_view, &probe.measured,
                       "An edge that all but lies along the grid");
    probe_end(&probe);
    return ok;
}

// What flipped beside what moved in truth, per length of the edge: texels.
static double flipped(const double *before, const double *after, double moved) {
    double sum = 0;
    for (int x = 0; x < WIDE; x++)
        sum += fabs(after[x] - before[x] - moved) / WIDE;
    return sum * unit / texel();
}

typedef struct Sweep {
    bool turns; // the sun; else the camera moves
    bool snapped;
    double pixels; // a step of the camera
} Sweep;

// A step of the camera is whole pixels, so that each pixel meets a place of the wall that another one met
// before. When the sun turns by a, the edge goes down by h sin a in the sun's own plane, in which the grid
// lies.
static bool sweep(LabSet *labs, Findings *findings, Curve *curve, Sweep with) {
    double before[WIDE], after[WIDE], truth[2];
    Scene scene = edge_scene(0, 0);
    bool ok = draw(labs, findings, &scene, with.snapped, before, &truth[0]);
    // A column of texels more or less, and each of the others off by up to half a pixel, in the mean of them
    // all.
    const double columns = WIDE * unit / texel(), pixel = unit / texel();
    const double tolerance = 1 / columns + pixel / 2;
    for (int i = 1; ok && i <= STEPS; i++) {
        double shift = with.turns ? i * texel() / STEPS : i * with.pixels * unit;
        double d = shift / texel() - floor(shift / texel());
        scene = with.turns ? edge_scene(0, asin(shift / board_height)) : edge_scene(shift, 0);
        ok = draw(labs, findings, &scene, with.snapped, after, &truth[1]);
        bool still = with.snapped && !with.turns;
        if (ok) // a still edge: one pixel may lie on a texel's border, to the last bit
            curve_add(curve, shift / texel(), flipped(before, after, truth[1] - truth[0]),
                      still ? 0 : 2 * d * (1 - d), still ? pixel / WIDE : tolerance);
    }
    return ok;
}

static bool run_motion(LabSet *labs, Findings *findings) {
    Figure *figure =
        findings_figure(findings, "The camera moves, or the sun turns", "shift of map or edge (texels)",
                        "flipped area per length of the edge (texels)");
    Curve *moved = figure_curve(figure, "failure: the camera moves", CURVE_EQUAL),
          *snapped = figure_curve(figure, "remedy: whole texels", CURVE_EQUAL),
          *turned = figure_curve(figure, "failure: the sun turns, whole texels", CURVE_EQUAL);
    return sweep(labs, findings, moved, (Sweep){.pixels = 2}) &&
           sweep(labs, findings, snapped, (Sweep){.snapped = true, .pixels = 3}) &&
           sweep(labs, findings, turned, (Sweep){.turns = true, .snapped = true});
}

const Row LAB_TABLE[] = {
    {100 * LAB_NUMBER + 1, "maps that follow the camera", "cascades, one slice",
     "the camera moves by 0 to 3 texels; the sun turns so that the edge moves by 0 to 1 texel",
     "A map that follows the camera takes its grid along: an edge that stands still flips by 2 d (1 - d) "
     "texels. On "
     "a grid of whole texels nothing changes. When the sun turns, the edge moves over the grid, and beside "
     "its true "
     "motion it flips by 2 d (1 - d) again, whole texels or not.",
     "closed form", run_motion},
    {0},
};
