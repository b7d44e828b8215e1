// How wide a penumbra is, and what two blockers do to it. A lamp straight before a wall, plates parallel to
// it: each tap's edge lies at most half a texel, and the offset's, aside.
#include "scene/count.h"
#include "stability/probe.h"
#include "stability/row.h"
#include "truth/closed_scenes.h"

enum { WIDE = 480, HIGH = 16, TAPS = 24, MAP = 2048 };
static const double extent = 0.5; // half the lamp's side

static Scene lamp_and_wall(void) {
    Scene scene = closed_wall_and_lamp(WIDE, HIGH);
    scene.lights[0].extent = (float)extent;
    return scene;
}

static double width_of(double h) {
    return 2 * extent * h / (CLOSED_LAMP_AT - h);
}

// Over the wall in the middle row: the integral of V (1 - V), and of the light that is false.
static void integrate(const Probe *probe, double *variance, double *leak) {
    const MetricsSize size = probe->truth_view.size;
    double unit = probe_unit(probe);
    *variance = *leak = 0;
    for (int x = 0; x < size.width; x++) {
        size_t i = (size_t)(size.height / 2) * (size_t)size.width + (size_t)x;
        if (probe->truth_view.picture.hits[i].object != 0)
            continue;
        double lit = probe->measured.visibility[i];
        *variance += lit * (1 - lit) * unit;
        *leak += (lit - probe->truth_view.visibility[i]) * unit;
    }
}

static bool draw(Probe *probe, LabSet *labs, const Scene *scene, int kernel) {
    bool ok = probe_begin(probe, labs, LAB_ID, scene, WIDE, HIGH);
    probe_knob(probe, "map size", MAP);
    probe_knob(probe, "filter taps", TAPS);
    probe_knob(probe, "search taps", 16);
    probe_knob(probe, "kernel", kernel);
    probe_knob(probe, "fixed side", 2);
    return ok && probe_draw(probe);
}

// n taps in a row make n + 1 levels of a ramp of width w, and its integral of V (1 - V) is w (1 - 1 / n^2)
// / 6.
static bool run_widths(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "The width of a penumbra",
                                     "height of the caster over the wall (units)", "width (units)");
    Curve *soft = figure_curve(figure, "by the mean blocker: S h / (H - h)", CURVE_EQUAL),
          *fixed = figure_curve(figure, "failure: a fixed kernel has one width", CURVE_EQUAL);
    const double levels = 1 - 1.0 / (TAPS * TAPS), tolerance = closed_lamp_texel(MAP) + 2.0 / WIDE;
    bool ok = true;
    for (int i = 1; ok && i <= 6; i++) {
        double h = 0.5 * i, variance, leak;
        Scene scene = lamp_and_wall();
        closed_plate(&scene, h, 0);
        for (int kernel = 0; ok && kernel < 2; kernel++) {
            Probe probe;
            ok = draw(&probe, labs, &scene, kernel);
            if (ok) {
                integrate(&probe, &variance, &leak);
                double width = 6 * variance / levels, one = 0.02 * closed_lamp_texel(MAP) * MAP;
                curve_add(kernel ? soft : fixed, h, width, kernel ? width_of(h) : one, tolerance);
                findings_frame(findings, kernel, fabs(width - width_of(h)), &probe.truth_view,
                               &probe.measured, "%s, a plate at %.1f",
                               kernel ? "The mean blocker" : "A fixed kernel", h);
            }
            probe_end(&probe);
        }
    }
    return ok;
}

// Two plates whose shadows end in one place, w and v < w wide. The map sees the one nearer to the lamp only,
// so the kernel's ramp is its own; in truth the dark half belongs to the other: (w - v) / 8 of light is
// false.
static bool run_two(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "Two blockers, shadows that end in one place",
                                     "height of the lower one (units)", "false light along the edge (units)");
    Curve *leaks = figure_curve(figure, "failure: the lower one is not in the map, (w - v) / 8", CURVE_EQUAL);
    const double high = 3;
    bool ok = true;
    for (int i = 1; ok && i <= 5; i++) {
        double h = 0.5 * i, variance, leak;
        Scene scene = lamp_and_wall();
        closed_plate(&scene, high, 0);
        closed_plate(&scene, h, 0);
        Probe probe;
        ok = draw(&probe, labs, &scene, 1);
        if (ok) {
            integrate(&probe, &variance, &leak);
            // Half a texel moves the whole ramp, which counts once; its two halves balance in the mean of the
            // taps.
            curve_add(leaks, h, leak, (width_of(high) - width_of(h)) / 8,
                      closed_lamp_texel(MAP) / 2 + 2.0 / 255 * width_of(high));
            findings_frame(findings, 0, leak, &probe.truth_view, &probe.measured, "Plates at %.1f and %.1f",
                           high, h);
        }
        probe_end(&probe);
    }
    return ok;
}

const Row LAB_TABLE[] = {
    {100 * LAB_NUMBER + 1, "penumbra's width", "a kernel for each point",
     "the caster's height, 0.5 to 3 of 8 units",
     "A parallel caster: the kernel is the lamp seen through the point, and the penumbra S h / (H - h) wide. "
     "A fixed "
     "kernel has one width for all heights.",
     "closed form; R. Fernando: Percentage-Closer Soft Shadows, SIGGRAPH sketches, 2005", run_widths},
    {100 * LAB_NUMBER + 2, "two blockers", "a kernel for each point",
     "the lower caster's height, 0.5 to 2.5 units",
     "Two casters whose shadows end in one place: the map holds the upper one alone, so the penumbra is as "
     "wide as its "
     "own on both sides; in truth it is narrower where the lower one hides the lamp. (w - v) / 8 of light "
     "per length "
     "of the edge is false.",
     "closed form", run_two},
    {0},
};
