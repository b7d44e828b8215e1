// Soft edges: what a number of samples makes of a straight edge. A plate before a wall under light from the
// left, 45 degrees aslant.
#include "truth/closed_scenes.h"
#include "stability/probe.h"
#include "stability/row.h"

static const float half_size = 4;

static Scene lit_wall(float width) {
    Scene scene = closed_wall(6, 10, 2 * atanf(width / 20));
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(-6, 0, 6), vec3_make(0, 0, 0), 0, half_size, 1, 14);
    return scene;
}

// Visibility beside a half-plane for a disc of radius 1, t from its edge.
static double half_plane(double t) {
    return fabs(t) < 1 ? 0.5 + (t * sqrt(1 - t * t) + asin(t)) / GLM_PI : t > 0;
}

enum { RANDOM_MAP = 1024, PATTERN = 64, RANDOM_HEIGHT = 256 };
static const double radius = 0.4; // of the disc, in the light's cross-section

// The truth is that of the disc, not of a point: visibility at the height y above the edge.
static void set_truth(Probe *probe) {
    for (int i = 0; i < PATTERN * RANDOM_HEIGHT; i++)
        probe->truth_view.visibility[i] =
            (float)half_plane(probe->truth_view.picture.hits[i].position.y / radius);
}

// Root of the mean squared error over the penumbra, and what independent samples would make of it.
static void noise(const Probe *probe, int samples, double *rms, double *independent) {
    double sum = 0, variance = 0, count = PATTERN * RANDOM_HEIGHT;
    for (int i = 0; i < PATTERN * RANDOM_HEIGHT; i++) {
        double v = probe->truth_view.visibility[i], off = probe->measured.visibility[i] - v;
        sum += off * off;
        variance += v * (1 - v);
    }
    *rms = sqrt(sum / count);
    *independent = sqrt(variance / count / samples);
}

// Lab 06's samples lie one to a cell of a grid; without the grid they are independent.
static const Change independent_samples = {
    .name = "no cells",
    .edits = {{"offsets.h", "((float)column + 0.5f + jitter.x) / (float)pattern->columns",
               "jitter.x + 0.5f + 0 * (float)column"},
              {"offsets.h", "((float)row + 0.5f + jitter.y) / (float)pattern->rows",
               "jitter.y + 0.5f + 0 * (float)row"}},
    .edit_count = 2};

static bool begin_noise(Probe *probe, LabSet *labs) {
    Scene scene = lit_wall((float)(2.04 * radius));
    closed_add(&scene, SHAPE_BOX, vec3_make(-3.6F, -2, 3), vec3_make(2.4F, 2, 0.01F), 0);
    bool ok = probe_begin(probe, labs, LAB_ID, &scene, PATTERN, RANDOM_HEIGHT);
    if (ok)
        set_truth(probe);
    probe_knob(probe, "map size", RANDOM_MAP);
    probe_knob(probe, "radius", radius / (2 * half_size) * RANDOM_MAP);
    probe_knob(probe, "pattern size", PATTERN);
    probe_knob(probe, "early-out", 0);
    return ok;
}

// Four standard errors of a root mean square over as many pixels as have a pattern of their own, relative.
static double rms_tolerance(void) {
    return 4 / sqrt(2.0 * PATTERN * PATTERN);
}

static bool sweep_samples(LabSet *labs, Findings *findings, Curve *slope, Curve *level,
                          const Change *change) {
    static const int sides[] = {4, 6, 8, 12, 16};
    Probe probe;
    bool ok = begin_noise(&probe, labs);
    probe.change = change;
    for (int i = 0; ok && i < 5; i++) {
        double rms, independent;
        probe_knob(&probe, "columns", sides[i]);
        probe_knob(&probe, "rows", sides[i]);
        ok = probe_draw(&probe);
        if (!ok)
            break;
        noise(&probe, sides[i] * sides[i], &rms, &independent);
        curve_add(slope, sides[i] * sides[i], rms, 0, 0);
        if (level)
            curve_add(level, sides[i] * sides[i], rms, independent, rms_tolerance() * independent);
        findings_frame(findings, change ? 1 : 0, rms, &probe.truth_view, &probe.measured, "%d samples, %s",
                       sides[i] * sides[i], change ? "independent" : "one to a cell");
    }
    probe_end(&probe);
    return ok;
}

static bool run_random(LabSet *labs, Findings *findings) {
    Figure *figure =
        findings_figure(findings, "A penumbra", "samples a pixel", "RMS error of the visibility");
    Curve *jittered = figure_curve(figure, "one sample to a cell", CURVE_SLOPE);
    Curve *independent = figure_curve(figure, "independent samples", CURVE_SLOPE);
    Curve *level = figure_curve(figure, "independent: sqrt(mean of V (1 - V) / n)", CURVE_EQUAL);
    figure->log_x = figure->log_y = true;
    jittered->slope = -0.75;
    independent->slope = -0.5;
    jittered->tolerance = independent->tolerance = 0.05;
    return sweep_samples(labs, findings, jittered, NULL, NULL) &&
           sweep_samples(labs, findings, independent, level, &independent_samples);
}

const Row LAB_TABLE[] = {
    {16, "number of samples", "random sampling", "16 to 256 samples a pixel, in cells and independent",
     "Independent samples: sqrt(V (1 - V) / n), slope -1/2. One to a cell: only the cells that the edge "
     "crosses, about sqrt n of n, make noise, so the slope is -3/4.",
     "closed form; D. Mitchell: Consequences of Stratified Sampling in Graphics, SIGGRAPH 1996", run_random},
    {0},
};
