// The slide's matrix, and what n x n lamps can say of a wide one.
#include "scene/count.h"
#include "stability/probe.h"
#include "stability/row.h"
#include "truth/closed_scenes.h"

#include <stdio.h>

enum { SIDE = 160, WIDE = 320 };

// Row 1 of lecture 004's matrix: (Ly, -Lz, 0, 0) for (Ly, -Lx, 0, 0).
static const Change slide = {.name = "the slide's first row",
                             .edits = {{"flatten.h", "light.raw[row] * plane.raw[column]",
                                        "light.raw[row == 0 ? 2 : row] * plane.raw[column]"}},
                             .edit_count = 1};
static const Change eight_bits = {
    .name = "a sum in 8 bits", .edits = {{"lab.c", "format = GL_R32F", "format = GL_R8"}}, .edit_count = 1};

// A floor from straight above, a plate at height 1.5, and a sun 45 degrees high.
static Scene floor_and_sun(int azimuth) {
    double turn = closed_radians(azimuth);
    Scene scene = {
        .camera = {.eye = vec3_make(0, 10, 0), .fov_y = glm_rad(40), .near_plane = 1, .far_plane = 20}};
    scene.second_camera = scene.camera;
    closed_add(&scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(6, 1, 6), 0);
    closed_add(&scene, SHAPE_BOX, vec3_make(0, 1.5f, 0), vec3_make(0.25f, 1e-5f, 0.25f), 0);
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(8 * (float)sin(turn), 8, 8 * (float)cos(turn)),
                 vec3_make(0, 0, 0), 0, 5, 1, 30);
    return scene;
}

// The x of the middle of what is dark on object 0.
static double middle_of_dark(const Probe *probe) {
    const TruthView *view = &probe->truth_view;
    double sum = 0, count = 0;
    for (size_t i = 0; i < (size_t)view->size.width * (size_t)view->size.height; i++)
        if (view->picture.hits[i].object == 0 && probe->measured.visibility[i] < 0.5f) {
            sum += view->picture.hits[i].position.x;
            count++;
        }
    return count > 0 ? sum / count : NAN;
}

// The shadow's middle lies at x = -h Lx / Ly; the slide has it at -h Lz / Ly.
static bool run_slide(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "Where the shadow lies", "azimuth of the sun (degrees)",
                                     "x of the shadow's middle (units)");
    Curve *good = figure_curve(figure, "(Ly, -Lx, 0, 0)", CURVE_EQUAL),
          *failure = figure_curve(figure, "failure: the slide's (Ly, -Lz, 0, 0)", CURVE_EQUAL);
    const int azimuths[] = {0, 30, 45, 60, 120, 135, 150, 180}; // none that hides it under the plate
    bool ok = true;
    for (size_t i = 0; ok && i < COUNT(azimuths); i++) {
        const Scene scene = floor_and_sun(azimuths[i]);
        double turn = closed_radians(azimuths[i]), pixel = 2 * 10 * tan(closed_radians(20)) / SIDE;
        Probe probe;
        ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE) && probe_draw(&probe);
        if (ok)
            curve_add(good, azimuths[i], middle_of_dark(&probe), -1.5 * sin(turn), pixel / 2);
        probe.change = &slide;
        ok = ok && probe_draw(&probe);
        if (ok) {
            curve_add(failure, azimuths[i], middle_of_dark(&probe), -1.5 * cos(turn), pixel / 2);
            findings_frame(findings, 0, probe.measured.metrics.all.mae, &probe.truth_view, &probe.measured,
                           "The slide's matrix, the sun at %d degrees", azimuths[i]);
        }
        probe_end(&probe);
    }
    return ok;
}

// A lamp of side 0.8 at height 5 before a wall, and a plate at height 2.5 whose edge throws a penumbra along
// x.
static Scene wide_lamp(void) {
    Scene scene = closed_wall(6, 10, glm_rad(20));
    closed_add(&scene, SHAPE_BOX, vec3_make(-2.7f, 0, 2.5f), vec3_make(1.2f, 1.2f, 1e-5f), 0);
    closed_light(&scene, LIGHT_POINT, vec3_make(-3, 0, 5), vec3_make(-3, 0, 0), 1, 0, 1, 20);
    scene.lights[0].extent = 0.4f;
    return scene;
}

// The mean and the largest distance from the line on which light falls in the penumbra, along the middle row,
// and how many levels are three pixels wide there.
static int measure_steps(const Probe *probe, double *mean, double *most) {
    const TruthView *view = &probe->truth_view;
    int count = 0, row = view->size.height / 2, alike = 0, levels = 0, before = -1;
    *mean = *most = 0;
    for (int x = 0; x < view->size.width; x++) {
        size_t i = (size_t)row * (size_t)view->size.width + (size_t)x;
        double t = view->picture.hits[i].position.x / 0.8 + 0.5; // the edge lies at x = -1.5 * 2 + 3 = 0
        if (t <= 0 || t >= 1 || view->picture.hits[i].object != 0)
            continue;
        double lit = probe->measured.visibility[i], off = fabs(lit - t);
        int level = (int)lround(255 * lit);
        *mean += off;
        *most = fmax(*most, off);
        alike = level == before ? alike + 1 : 1;
        levels += alike == 3;
        before = level;
        count++;
    }
    *mean /= count;
    return levels;
}

enum { MEAN, MOST, JITTERED_MOST, LEVELS, STEP_CURVES };

// Each lamp stays in its cell, so those of a column go dark while the line falls by 1 / n, one after the
// other. (Of 8 x 8 and more most of these steps are narrower than three pixels.)
static bool add_jittered(Probe *probe, Curve *curves[STEP_CURVES], int n, double tolerance) {
    double mean, most;
    probe_knob(probe, "jitter", 1);
    if (!probe_draw(probe))
        return false;
    const int levels = measure_steps(probe, &mean, &most);
    curve_add(curves[JITTERED_MOST], n, most, 1.0 / n, tolerance);
    if (n == 2 || n == 4)
        curve_add(curves[LEVELS], n, levels, n + 2, 0);
    return true;
}

static bool add_steps(LabSet *labs, Findings *findings, Curve *curves[STEP_CURVES], int n) {
    const Scene scene = wide_lamp();
    double mean, most, pixel = closed_unit(&scene, WIDE) / 0.8; // of the penumbra's width
    const double tolerance = pixel / 2 + 0.5 / 255;
    Probe probe;
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, WIDE, WIDE);
    probe_knob(&probe, "lamps", n);
    probe_knob(&probe, "jitter", 0);
    ok = ok && probe_draw(&probe);
    if (ok) {
        measure_steps(&probe, &mean, &most);
        curve_add(curves[MEAN], n, mean, 1 / (4.0 * n), tolerance);
        curve_add(curves[MOST], n, most, 1 / (2.0 * n), tolerance);
        findings_frame(findings, 0, -n, &probe.truth_view, &probe.measured, "%d x %d lamps", n, n);
    }
    ok = ok && add_jittered(&probe, curves, n, tolerance);
    probe_end(&probe);
    return ok;
}

// The umbra takes half of the light: n x n shares of 127.5 / (n n) steps, each rounded where there are 255.
static bool add_sum(LabSet *labs, Curve *floats, Curve *bytes, int n) {
    const Scene scene = wide_lamp();
    Probe probe;
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE);
    probe_knob(&probe, "lamps", n);
    probe_knob(&probe, "jitter", 0);
    probe_knob(&probe, "opacity", 0.5);
    size_t umbra = (size_t)(SIDE / 2) * SIDE + SIDE / 8; // x = -1.3
    ok = ok && probe_draw(&probe);
    if (ok)
        curve_add(floats, n * n, 1 - probe.measured.visibility[umbra], 0.5, 0.51 / 255);
    probe.change = &eight_bits;
    ok = ok && probe_draw(&probe);
    if (ok)
        curve_add(bytes, n * n, 1 - probe.measured.visibility[umbra],
                  fmin(1, n * n * round(127.5 / (n * n)) / 255), 0.51 / 255);
    probe_end(&probe);
    return ok;
}

static bool run_lamps(LabSet *labs, Findings *findings) {
    Figure *steps = findings_figure(findings, "Steps in the penumbra", "lamps along a side",
                                    "distance from the true line"),
           *levels =
               findings_figure(findings, "Levels of the penumbra", "lamps along a side", "levels of light"),
           *sums = findings_figure(findings, "The sum in the umbra", "lamps", "light taken (true: 0.5)");
    steps->log_x = steps->log_y = true;
    Curve *curves[STEP_CURVES] = {
        [MEAN] = figure_curve(steps, "mean", CURVE_EQUAL),
        [MOST] = figure_curve(steps, "largest", CURVE_EQUAL),
        [JITTERED_MOST] = figure_curve(steps, "jittered, largest: each lamp in its cell", CURVE_MOST),
        [LEVELS] = figure_curve(levels, "jittered: more than the n + 1 of regular ones", CURVE_LEAST)};
    Curve *floats = figure_curve(sums, "32-bit floats", CURVE_EQUAL),
          *bytes = figure_curve(sums, "failure: 8 bits", CURVE_EQUAL);
    const int some[] = {3, 5, 6, 7, 9, 10, 12, 14}; // none whose share is near a half step
    bool ok = true;
    for (int n = 1; ok && n <= 16; n *= 2)
        ok = add_steps(labs, findings, curves, n);
    for (size_t i = 0; ok && i < COUNT(some); i++)
        ok = add_sum(labs, floats, bytes, some[i]);
    return ok;
}

const Row LAB_TABLE[] = {
    {100 * LAB_NUMBER + 1, "the slide's matrix", "casters flattened onto a floor", "the sun's azimuth",
     "The matrix of lecture 004 has -Lz in its first row where -Lx is right: the shadow's middle lies at -h "
     "Lz / "
     "Ly instead of -h Lx / Ly. It is right only where the sun's azimuth is 45 degrees (or -135).",
     "closed form", run_slide},
    {100 * LAB_NUMBER + 2, "n x n lamps", "a wide lamp as many small ones, summed",
     "1 to 16 lamps along a side; 9 to 196 shares in 8 bits and in floats",
     "n regular lamps along a side make n + 1 levels, at most 1 / (2 n) and in the mean 1 / (4 n) away from "
     "the "
     "line on which light falls in a penumbra. Jittered ones stay in their cells: at most 1 / n away, and "
     "more levels, for those of a column go dark one after the other. Eight bits round each share, so that "
     "errors add up; floats do "
     "not.",
     "closed form; Heckbert, Herf: Simulating Soft Shadows with Graphics Hardware, 1997", run_lamps},
    {0},
};
