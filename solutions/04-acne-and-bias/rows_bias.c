// Acne on a bare wall and what ends it. s is a texel, theta the angle between light and normal.
#include "stability/probe.h"
#include "stability/row.h"
#include "stability/tilted.h"

enum { WIDTH = 400, HEIGHT = 100, NONE = 0, CONSTANT, SLOPE, POLYGON_OFFSET };
static const float half_size = 4;

// Of a share counted over a wall whose pixels fall on texels at phases that never repeat: the rows of the
// picture are alike at psi = 0, so WIDTH phases must do, evenly spread but for a few.
static const double share_tolerance = 4.0 / WIDTH;

static const char share[] = "false shadow (share of the wall)";

static bool begin_wall(Probe *probe, LabSet *labs, double theta, double psi) {
    const Scene scene = tilted_wall(theta, psi, half_size, (double)WIDTH / HEIGHT);
    return probe_begin(probe, labs, LAB_ID, &scene, WIDTH, HEIGHT);
}

static double false_shadow(const Probe *probe) {
    return probe->measured.metrics.all.false_shadow;
}

static bool run_map(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "A bare wall without bias", "map size (texels)", share);
    Curve *curve = figure_curve(figure, "no bias", CURVE_EQUAL);
    Probe probe;
    bool ok = begin_wall(&probe, labs, 60, 25);
    figure->log_x = true;
    probe_knob(&probe, "method", NONE);
    for (int size = 128; ok && size <= 4096; size *= 2) {
        probe_knob(&probe, "map size", size);
        ok = probe_draw(&probe);
        if (!ok)
            break;
        curve_add(curve, size, false_shadow(&probe), 0.5, share_tolerance);
        findings_frame(findings, 0, 1.0 / size, &probe.truth_view, &probe.measured, "A map of %d texels",
                       size);
    }
    probe_end(&probe);
    return ok;
}

// Depth of the map that a world length along the light is.
static double map_depth(double world) {
    return world / (TILTED_FAR - TILTED_NEAR);
}

static bool sweep_ratio(LabSet *labs, Findings *findings, Curve *curve, double psi) {
    enum { MAP = 512 };
    Probe probe;
    bool ok = begin_wall(&probe, labs, 60, psi);
    double least = 0.5 * 2 * half_size / MAP * tilted_slope(&probe.truth_view.truth.scene);
    probe_knob(&probe, "method", CONSTANT);
    probe_knob(&probe, "map size", MAP);
    for (int i = 0; ok && i <= 8; i++) {
        double r = i < 7 ? i / 6.0 * 0.96 : i == 7 ? 1.02 : 1.2;
        probe_knob(&probe, "bias", map_depth(r * least));
        ok = probe_draw(&probe);
        if (!ok)
            break;
        curve_add(curve, r, false_shadow(&probe), tilted_acne(r, psi), r > 1 ? 0 : share_tolerance);
        findings_frame(findings, 0, false_shadow(&probe), &probe.truth_view, &probe.measured,
                       "A bias of %.2f times the least one, slope at %.0f degrees in the map", r, psi);
    }
    probe_end(&probe);
    return ok;
}

static bool run_constant(LabSet *labs, Findings *findings) {
    Figure *figure =
        findings_figure(findings, "Constant bias on a tilted wall", "r = bias / (s tan(theta) K / 2)", share);
    return sweep_ratio(labs, findings, figure_curve(figure, "slope along an axis", CURVE_EQUAL), 0) &&
           sweep_ratio(labs, findings, figure_curve(figure, "slope along the diagonal", CURVE_EQUAL), 45);
}

// glPolygonOffset moves the map by factor * max(|dz/dx|, |dz/dy|) for each texel: at psi = 0 a factor of 1/2
// reaches from the texel's middle to its border, along the diagonal it needs 1 to reach the corner.
static bool sweep_factor(LabSet *labs, Findings *findings, Curve *curve, double psi) {
    double enough = psi > 0 ? 1 : 0.5;
    Probe probe;
    bool ok = begin_wall(&probe, labs, 70, psi);
    probe_knob(&probe, "method", POLYGON_OFFSET);
    probe_knob(&probe, "map size", 512);
    for (int i = 0; ok && i <= 8; i++) {
        double factor = i < 6 ? 0.16 * i : i == 6 ? 1.02 : i == 7 ? 1.5 : 2, r = factor / enough;
        probe_knob(&probe, "factor", factor);
        ok = probe_draw(&probe);
        if (!ok)
            break;
        curve_add(curve, factor, false_shadow(&probe), tilted_acne(r, psi), r > 1 ? 0 : share_tolerance);
        findings_frame(findings, 0, false_shadow(&probe), &probe.truth_view, &probe.measured,
                       "Factor %.2f, slope at %.0f degrees in the map", factor, psi);
    }
    probe_end(&probe);
    return ok;
}

// Lab 04's other slope bias, max(b_s (1 - N.L), b_c), is no match for tan(theta): just enough at 45 degrees,
// it is too small for steeper and for flatter walls; its floor b_c, just enough at 20 degrees, helps the flat
// ones only.
static bool sweep_slope_bias(LabSet *labs, Findings *findings, Curve *curve) {
    enum { MAP = 512 };
    const double texel = 2 * half_size / MAP, at45 = texel / 2 / (1 - M_SQRT1_2),
                 at20 = texel / 2 * tan(closed_radians(20));
    bool ok = true;
    for (int theta = 8; ok && theta <= 80; theta += 8) {
        double angle = closed_radians(theta), least = texel / 2 * tan(angle);
        double r = fmax(at45 * (1 - cos(angle)), at20) / least;
        Probe probe;
        ok = begin_wall(&probe, labs, theta, 0);
        probe_knob(&probe, "method", SLOPE);
        probe_knob(&probe, "map size", MAP);
        probe_knob(&probe, "slope bias", map_depth(at45));
        probe_knob(&probe, "bias", map_depth(at20));
        ok = ok && probe_draw(&probe);
        if (ok) {
            curve_add(curve, theta, false_shadow(&probe), tilted_acne(r, 0), r > 1.01 ? 0 : share_tolerance);
            findings_frame(findings, 1, false_shadow(&probe), &probe.truth_view, &probe.measured,
                           "Slope bias by 1 - N.L, light at %d degrees", theta);
        }
        probe_end(&probe);
    }
    return ok;
}

static bool run_slope_scaled(LabSet *labs, Findings *findings) {
    Figure *offset = findings_figure(findings, "Polygon offset on a steep wall", "factor", share);
    Figure *bias = findings_figure(findings, "Bias by 1 - N.L", "light's angle theta (degrees)", share);
    return sweep_factor(labs, findings, figure_curve(offset, "slope along an axis", CURVE_EQUAL), 0) &&
           sweep_factor(labs, findings, figure_curve(offset, "slope along the diagonal", CURVE_EQUAL), 45) &&
           sweep_slope_bias(labs, findings,
                            figure_curve(bias, "failure: max(b_s (1 - N.L), b_c)", CURVE_EQUAL));
}

const Row LAB_TABLE[] = {
    {1, "acne and resolution", "shadow map without bias", "map size, 128 to 4096 texels",
     "Half of the wall is in false shadow, however fine the map: in each texel one half lies behind the "
     "depth of its middle.",
     "closed form, by symmetry of the texel", run_map},
    {2, "constant bias", "constant bias", "the bias, as a multiple r of the least one that is enough",
     "(1 - r) / 2 along an axis of the map, (1 - r)^2 / 2 along its diagonal, and nothing from r = 1 on: "
     "the share of a texel that lies deeper than its middle by more than the bias.",
     "closed form", run_constant},
    {3, "slope-scaled bias", "glPolygonOffset; bias by 1 - N.L",
     "the factor, 0 to 2; the light's angle, 8 to 80 degrees",
     "Polygon offset: as row 2 with r = factor / m along an axis and factor / 2m along the diagonal, m = "
     "1/2 for a nearest lookup: OpenGL scales by the larger of the two slopes, not by their sum. Nothing "
     "from m to 2m on. A bias by 1 - N.L does not follow tan(theta): enough at one angle, it leaves acne on "
     "steeper and on flatter walls; a floor helps the flat ones only.",
     "closed form; OpenGL 4.1 core, Depth Offset", run_slope_scaled},
    {0},
};
