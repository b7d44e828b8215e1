// Soft edges: what a filter of a given width or number of samples makes of a straight edge. A plate before a
// wall under light from the left, 45 degrees aslant; the edge lies on a border of texels, so that each
// comparison is right.
#include "scene/count.h"
#include "truth/closed_scenes.h"
#include "stability/probe.h"
#include "stability/row.h"

static const float half_size = 4;

static Scene lit_wall(float width) {
    Scene scene = closed_wall(6, 10, 2 * atanf(width / 20));
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(-6, 0, 6), vec3_make(0, 0, 0), 0, half_size, 1, 14);
    return scene;
}

// Integrals of the error and of its square across the edge, in texels, over the rows of the picture.
static void integrate(const Probe *probe, double texel, double *error, double *square) {
    const MetricsSize size = probe->truth_view.size;
    double step = probe_unit(probe) * M_SQRT1_2 / texel / size.height;
    *error = *square = 0;
    for (int i = 0; i < size.width * size.height; i++) {
        double off = fabsf(probe->measured.visibility[i] - probe->truth_view.visibility[i]);
        *error += off * step;
        *square += off * off * step;
    }
}

enum { WIDTH = 800, ROWS = 8, MAP = 128, BOX = 4 };

static bool begin_edge(Probe *probe, LabSet *labs) {
    Scene scene = lit_wall(4.0F * ROWS / WIDTH);
    closed_add(&scene, SHAPE_BOX, vec3_make(-4, 0, 2), vec3_make(2, 3, 0.001F), 0);
    return probe_begin(probe, labs, "05", &scene, WIDTH, ROWS);
}

static bool run_box(LabSet *labs, Findings *findings) {
    const double texel = 2 * half_size / MAP;
    Figure *figure = findings_figure(findings, "A straight edge", "width w of the kernel (texels)",
                                     "error across the edge (texels)");
    Curve *error = figure_curve(figure, "absolute error: w / 4", CURVE_EQUAL);
    Curve *square = figure_curve(figure, "squared error: w / 12", CURVE_EQUAL);
    Probe probe;
    bool ok = begin_edge(&probe, labs);
    probe_knob(&probe, "method", BOX);
    probe_knob(&probe, "map size", MAP);
    for (int k = 0; ok && k <= 8; k++) {
        double w = 2 * k + 1, pixel = probe_unit(&probe) * M_SQRT1_2 / texel, linear, squared;
        probe_knob(&probe, "kernel radius", k);
        ok = probe_draw(&probe);
        if (!ok)
            break;
        integrate(&probe, texel, &linear, &squared);
        // A picture has 255 steps and a driver's filter 256: two steps over the kernel's width; and the sum
        // over pixels errs by a part of one where the truth jumps.
        curve_add(error, w, linear, w / 4, w * 2 / 255 + pixel / 4);
        curve_add(square, w, squared, w / 12, w / 255 + pixel / 4);
        findings_frame(findings, 0, w, &probe.truth_view, &probe.measured,
                       "A box of %d x %d texels (%d rows are drawn)", (int)w, (int)w, ROWS);
    }
    probe_end(&probe);
    return ok;
}

// The other filters, in texels: `width` of what they make of the edge, `jumps` of it (of three nearest texels
// at both ends), and the integrals. Three texels: 1/3 beside the edge, a texel far on both sides. Two ramps
// of one texel, two texels apart, half as high: 1/4 from their slopes, twice, and 1/2 from between them.
static const struct Profile {
    const char *name;
    int method;
    double width, jumps, error, square;
} profiles[] = {{"hard: 0", 0, 0, 0, 0, 0},
                {"3 x 3 by hand: 2/3", 1, 2, 2 / 3.0, 2 / 3.0, 2 / 9.0},
                {"linear: 1/4", 2, 1, 0, 1 / 4.0, 1 / 12.0},
                {"4 diagonals: 1", 3, 3, 0, 1, 5 / 12.0},
                {"3 x 3 by gathers: 3/4", 5, 3, 0, 3 / 4.0, 3 / 12.0}};

static bool sweep_profile(LabSet *labs, const struct Profile *profile, Curve *error, Curve *square) {
    Probe probe;
    bool ok = begin_edge(&probe, labs);
    probe_knob(&probe, "method", profile->method);
    for (int map = MAP / 2; ok && map <= 2 * MAP; map *= 2) {
        double texel = 2 * half_size / map, pixel = probe_unit(&probe) * M_SQRT1_2 / texel, linear, squared,
               sum = (0.25 + profile->jumps / 2) * pixel;
        probe_knob(&probe, "map size", map);
        ok = probe_draw(&probe);
        if (!ok)
            break;
        integrate(&probe, texel, &linear, &squared);
        curve_add(error, map, linear, profile->error, profile->width * 2 / 255 + sum);
        curve_add(square, map, squared, profile->square, profile->width / 255 + sum);
    }
    probe_end(&probe);
    return ok;
}

static bool run_filters(LabSet *labs, Findings *findings) {
    Figure *errors = findings_figure(findings, "A straight edge by the other filters",
                                     "map size (texels a side)", "absolute error across the edge (texels)"),
           *squares = findings_figure(findings, "The same, squared", "map size (texels a side)",
                                      "squared error across the edge (texels)");
    bool ok = run_box(labs, findings);
    for (size_t i = 0; ok && i < COUNT(profiles); i++)
        ok = sweep_profile(labs, &profiles[i], figure_curve(errors, profiles[i].name, CURVE_EQUAL),
                           figure_curve(squares, profiles[i].name, CURVE_EQUAL));
    return ok;
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
    {15, "PCF blur", "percentage-closer filtering", "the kernel's width w, 1 to 17 texels; the map's size",
     "A box of width w makes a ramp as wide of a hard edge: w / 4 of absolute error per length of the edge, "
     "w / 12 of squared error. Softness that no real penumbra asked for is an error that grows with the "
     "kernel. Each other filter has its own share of a texel, whatever the map's size.",
     "closed form", run_filters},
    {16, "number of samples", "random sampling", "16 to 256 samples a pixel, in cells and independent",
     "Independent samples: sqrt(V (1 - V) / n), slope -1/2. One to a cell: only the cells that the edge "
     "crosses, about sqrt n of n, make noise, so the slope is -3/4.",
     "closed form; D. Mitchell: Consequences of Stratified Sampling in Graphics, SIGGRAPH 1996", run_random},
    {0},
};
