// Several lights add up; n x n maps make the levels of n x n lamps; and where the faces of a cube meet.
#include "stability/probe.h"
#include "stability/row.h"
#include "truth/closed_scenes.h"

#include <stdlib.h>

enum { SIDE = 160, WIDE = 320 }; // pixels along a side of a picture

static const Change one_for_all = {.name = "one visibility for all lights",
                                   .edits = {{"shade.frag", "return visibility(light, position_world)",
                                              "return visibility(0, position_world)"}},
                                   .edit_count = 1};
static const Change corners = {.name = "lamps at the cells' corners",
                               .edits = {{"maps.h", "(float)column + 0.5f", "(float)column"}},
                               .edit_count = 1};
// A wall, a plate before it, and `count` lights whose shadows of it do not meet: at (+-4.5, +-4.5, 9), the
// plate of side 1 at the height 3, so that the shadows have the side 1.5 and lie around (-+2.25, -+2.25).
static Scene lights_around(int first, int count) {
    Scene scene = closed_wall(6, 10, glm_rad(40));
    closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, 3), vec3_make(0.5f, 0.5f, 1e-4f), 0);
    for (int i = first; i < first + count; i++)
        closed_light(&scene, LIGHT_SPOT, vec3_make(i % 2 ? 4.5f : -4.5f, i / 2 ? 4.5f : -4.5f, 9),
                     vec3_make(0, 0, 0), glm_rad(70), 0, 1, 20);
    return scene;
}

static bool draw(Probe *probe, LabSet *labs, const Scene *scene, const Change *change) {
    bool ok = probe_begin(probe, labs, LAB_ID, scene, SIDE, SIDE);
    probe->change = change;
    return ok && probe_draw(probe);
}

// Adds the light of each of the `count` lights alone, divided by their number, to the sum.
static bool add_alone(LabSet *labs, int count, float *sum) {
    bool ok = true;
    for (int i = 0; ok && i < count; i++) {
        const Scene scene = lights_around(i, 1);
        Probe probe;
        ok = draw(&probe, labs, &scene, NULL);
        for (size_t k = 0; ok && k < (size_t)SIDE * SIDE; k++)
            sum[k] += probe.measured.visibility[k] / (float)count;
        probe_end(&probe);
    }
    return ok;
}

// The largest and the mean distance of the picture from the sum.
static void compare(const Probe *probe, const float *sum, double *most, double *mean) {
    *most = *mean = 0;
    for (size_t k = 0; k < (size_t)SIDE * SIDE; k++) {
        double off = fabs(probe->measured.visibility[k] - (double)sum[k]);
        *most = fmax(*most, off);
        *mean += off / (SIDE * SIDE);
    }
}

static bool add_count(LabSet *labs, Findings *findings, Curve *good, Curve *failure, int count) {
    const Scene scene = lights_around(0, count);
    float *sum = calloc((size_t)SIDE * SIDE, sizeof *sum);
    double most, mean, width = SIDE * closed_unit(&scene, SIDE), shadow = 1.5 * 1.5 / (width * width);
    Probe probe = {0};
    bool ok = sum && add_alone(labs, count, sum) && draw(&probe, labs, &scene, NULL);
    if (ok) {
        compare(&probe, sum, &most, &mean);
        curve_add(good, count, most, 0, 1.01 / 255);
        probe.change = &one_for_all;
        ok = probe_draw(&probe);
    }
    if (ok) { // the first shadow is too dark by (k - 1) / k, the others are missing: 1 / k each
        compare(&probe, sum, &most, &mean);
        curve_add(failure, count, mean, 2 * shadow * (count - 1) / count,
                  0.25 * shadow + 0.5 / 255); // edges: a pixel and a texel around each
        findings_frame(findings, 0, mean, &probe.truth_view, &probe.measured,
                       "One visibility for all, %d lights", count);
    }
    free(sum);
    probe_end(&probe);
    return ok;
}

static bool run_sum(LabSet *labs, Findings *findings) {
    Figure *largest = findings_figure(findings, "All lights, and the sum of each alone", "lights",
                                      "largest difference"),
           *means =
               findings_figure(findings, "The same with one visibility for all", "lights", "mean difference");
    Curve *good = figure_curve(largest, "each its own visibility", CURVE_EQUAL),
          *failure = figure_curve(means, "failure: one visibility for all", CURVE_EQUAL);
    bool ok = true;
    for (int count = 1; ok && count <= SCENE_MAX_LIGHTS; count++)
        ok = add_count(labs, findings, good, failure, count);
    return ok;
}

// A lamp of side 0.8 at height 5 before a wall, and a plate at height 2.5 whose edge throws a penumbra along
// x, as in lab 10's row.
static Scene wide_lamp(void) {
    Scene scene = closed_wall(6, 10, glm_rad(20));
    closed_add(&scene, SHAPE_BOX, vec3_make(-2.7f, 0, 2.5f), vec3_make(1.2f, 1.2f, 1e-5f), 0);
    closed_light(&scene, LIGHT_SPOT, vec3_make(-3, 0, 5), vec3_make(-3, 0, 0), glm_rad(80), 0, 1, 20);
    scene.lights[0].extent = 0.4f;
    return scene;
}

// Where in the penumbrapixel i lies, 0 to 1; beyond it less or more.
static double place_in_penumbra(const Probe *probe, size_t i) {
    const TruthHit *hit = &probe->truth_view.picture.hits[i];
    return hit->object == 0 ? (double)hit->position.x / 0.8 + 0.5 : -1; // the edge: -1.5 * 2 + 3 = 0
}

// Along the middle row: the mean and the largest distance from the line on which light falls in the penumbra,
// and how many levels it has there that are wider than a texel and a pixel: as steps of three pixels.
static int measure_steps(const Probe *probe, double *mean, double *most) {
    const MetricsSize size = probe->truth_view.size;
    int count = 0, alike = 0, levels = 0, before = -1;
    *mean = *most = 0;
    for (int x = 0; x < size.width; x++) {
        size_t i = (size_t)(size.height / 2) * (size_t)size.width + (size_t)x;
        double t = place_in_penumbra(probe, i), lit = probe->measured.visibility[i];
        if (t <= 0 || t >= 1)
            continue;
        int level = (int)lround(255 * lit);
        *mean += fabs(lit - t);
        *most = fmax(*most, fabs(lit - t));
        alike = level == before ? alike + 1 : 1;
        levels += alike == 3;
        before = level;
        count++;
    }
    *mean /= count;
    return levels;
}

// With the jitter each lamp lies elsewhere in its cell, so that those of a column do not go dark together.
// (Of 8 x 8 lamps most steps are narrower.)
static bool add_jittered(Probe *probe, Curve *curve, int n) {
    double mean, most;
    probe->change = NULL;
    probe_knob(probe, "jitter", 1);
    if (!probe_draw(probe))
        return false;
    curve_add(curve, n, measure_steps(probe, &mean, &most), n + 2, 0);
    return true;
}

static bool add_levels(LabSet *labs, Findings *findings, Curve *curves[4], int n) {
    const Scene scene = wide_lamp();
    double mean, most, shifted, size = 1024;
    double pixel = closed_unit(&scene, WIDE) / 0.8, texel = 2 * tan(closed_radians(40)) * 5 / size / 0.8;
    double tolerance = pixel / 2 + texel + 0.5 / 255; // in parts of the penumbra's width, and of the light
    Probe probe;
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, WIDE, WIDE);
    probe_knob(&probe, "lamps", n);
    probe_knob(&probe, "jitter", 0);
    probe_knob(&probe, "map size", size);
    ok = ok && probe_draw(&probe);
    if (ok) {
        measure_steps(&probe, &mean, &most);
        curve_add(curves[0], n, mean, 1 / (4.0 * n), tolerance);
        curve_add(curves[1], n, most, 1 / (2.0 * n), tolerance);
        findings_frame(findings, 0, -n, &probe.truth_view, &probe.measured, "%d x %d maps", n, n);
    }
    probe.change = &corners;
    ok = ok && probe_draw(&probe);
    if (ok) {
        measure_steps(&probe, &mean, &shifted);
        curve_add(curves[2], n, shifted, 1 / (double)n, tolerance);
    }
    ok = ok && (n == 1 || n == 8 || add_jittered(&probe, curves[3], n));
    probe_end(&probe);
    return ok;
}

static bool run_levels(LabSet *labs, Findings *findings) {
    Figure *steps = findings_figure(findings, "Steps in the penumbra", "lamps along a side",
                                    "distance from the true line");
    Figure *levels =
        findings_figure(findings, "Levels of the penumbra", "lamps along a side", "levels of light");
    steps->log_x = steps->log_y = true;
    Curve *curves[] = {figure_curve(steps, "mean", CURVE_EQUAL), figure_curve(steps, "largest", CURVE_EQUAL),
                       figure_curve(steps, "failure: lamps at the cells' corners, largest", CURVE_EQUAL),
                       figure_curve(levels, "jittered: more than the n + 1 of regular ones", CURVE_LEAST)};
    bool ok = true;
    for (int n = 1; ok && n <= 8; n *= 2)
        ok = add_levels(labs, findings, curves, n);
    return ok;
}

// A lamp at the height 1.5 before a bare wall: the edges of its face -z lie on the wall as a square of
// side 3.
static bool add_seam(LabSet *labs, Findings *findings, Curve *good, Curve *failure, int size) {
    Scene scene = closed_wall(6, 10, glm_rad(40));
    double height = 1.5, width = WIDE * closed_unit(&scene, WIDE);
    closed_light(&scene, LIGHT_POINT, vec3_make(0, 0, (float)height), vec3_make(0, 0, 0), 0, 0, 0.2f, 20);
    Probe probe;
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, WIDE, WIDE);
    probe_knob(&probe, "map size", size);
    ok = ok && probe_draw(&probe);
    if (ok)
        curve_add(good, size, probe.measured.metrics.all.mae, 0, 1e-6);
    probe_knob(&probe, "cube filter", 1);
    ok = ok && probe_draw(&probe);
    if (ok) {
        double expected = 2 * height * height / size / (width * width);
        curve_add(failure, size, probe.measured.metrics.all.mae, expected, 0.35 * expected);
        findings_frame(findings, 0, expected, &probe.truth_view, &probe.measured,
                       "A filter across the faces, %d texels", size);
    }
    probe_end(&probe);
    return ok;
}

static bool run_seam(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "False shadow at the edges of a cube's faces",
                                     "texels along a face", "mean over the picture");
    figure->log_x = true;
    Curve *good = figure_curve(figure, "each face by itself", CURVE_EQUAL),
          *failure = figure_curve(figure, "failure: GL_TEXTURE_CUBE_MAP_SEAMLESS", CURVE_EQUAL);
    bool ok = true;
    for (int size = 16; ok && size <= 56; size += 8) // half a texel is more than a pixel
        ok = add_seam(labs, findings, good, failure, size);
    return ok;
}

const Row LAB_TABLE[] = {
    {100 * LAB_NUMBER + 1, "lights add up", "a map for each light, visibilities summed", "1 to 4 lights",
     "The picture with all lights is the sum of the pictures with each alone, to the rounding of 8 bits. "
     "With "
     "one visibility for all k lights the first shadow is too dark by (k - 1) / k, and the others are "
     "missing.",
     "closed form", run_sum},
    {100 * LAB_NUMBER + 2, "n x n maps", "a wide light as n x n small lamps, a map each",
     "1 to 8 lamps along a side",
     "n regular lamps along a side make n + 1 levels, at most 1 / (2 n) and in the mean 1 / (4 n) away from "
     "the "
     "line on which light falls in a penumbra, as flattened casters (row 1002). At the cells' corners it is "
     "1 / n. Jittered lamps of a column go dark one after the other: more levels than n + 1.",
     "closed form", run_levels},
    {100 * LAB_NUMBER + 3, "the seams of a cube", "a cube of maps with projected depths",
     "16 to 56 texels along a face",
     "Next to an edge a filter across it compares the depth along one face's axis with depths along "
     "another's: "
     "false shadow half a texel wide, 2 h^2 / N of area in all around the face that looks at a wall from the "
     "distance h. With each face filtered by itself there is none.",
     "closed form", run_seam},
    {0},
};
