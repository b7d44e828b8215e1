// Light that two moments cannot keep away, and numbers that cannot keep the moments. A lamp that looks
// straight at a wall.
#include "stability/probe.h"
#include "stability/row.h"
#include "truth/closed_scenes.h"

enum { WIDE = 320, HIGH = 16, MAP = 1024, BLUR = 8, PLATES = 12 };
// The most light in the middle row of the wall where truth has none.
static double most_false(const Probe *probe) {
    const MetricsSize size = probe->truth_view.size;
    double most = 0;
    for (int x = 0; x < size.width; x++) {
        size_t i = (size_t)(size.height / 2) * (size_t)size.width + (size_t)x;
        if (probe->truth_view.picture.hits[i].object == 0 && probe->truth_view.visibility[i] <= 0 &&
            (double)probe->truth_view.picture.hits[i].position.x < 0.4)
            most = fmax(most, probe->measured.visibility[i]);
    }
    return most;
}

static bool draw(Probe *probe, double cut, int wide_numbers) {
    probe_knob(probe, "map size", MAP);
    probe_knob(probe, "blur", BLUR);
    probe_knob(probe, "mipmaps", 0);
    probe_knob(probe, "least variance", 1);
    probe_knob(probe, "cut", cut);
    probe_knob(probe, "numbers", wide_numbers);
    return probe_draw(probe);
}

static bool run_bleeding(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "Light under two plates", "distance a of the plates (units)",
                                     "most light where none is");
    Curve *bleeding = figure_curve(figure, "failure: a^2 / (a + 2 b)^2", CURVE_EQUAL),
          *cut = figure_curve(figure, "with a cut at that", CURVE_EQUAL);
    const double b = 1;
    bool ok = true;
    for (int i = 1; ok && i <= 6; i++) {
        double a = 0.5 * i, bound = a * a / ((a + 2 * b) * (a + 2 * b));
        Scene scene = closed_wall_and_lamp(WIDE, HIGH);
        Probe probe;
        closed_plate(&scene, b + a, 0);
        closed_plate(&scene, b, 0.6);
        ok = probe_begin(&probe, labs, LAB_ID, &scene, WIDE, HIGH) && draw(&probe, 0, 1);
        // At its top the bound is flat: half a texel of 17 beside it takes at most 0.01 of it away.
        if (ok)
            curve_add(bleeding, a, most_false(&probe), bound, 0.01 * bound + 1.0 / 255);
        if (ok)
            findings_frame(findings, 0, bound, &probe.truth_view, &probe.measured, "Plates %.1f apart", a);
        ok = ok && draw(&probe, bound + 0.002, 1);
        if (ok)
            curve_add(cut, a, most_false(&probe), 0, 0);
        probe_end(&probe);
    }
    return ok;
}

// One plate: its umbra has no light. A half float near t has steps of t / 1024 to t / 2048, its second moment
// of t^2: the variance of one depth is wrong by up to 1.5 t^2 / 1024, and the light by that over (t - mu)^2.
static bool run_halves(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "Light in the umbra", "height of the plate (units)",
                                     "most light where none is");
    Curve *halves = figure_curve(figure, "16-bit floats, at most", CURVE_MOST),
          *floats = figure_curve(figure, "32-bit floats, at most", CURVE_MOST),
          *worst = figure_curve(figure, "failure: 16-bit floats, the worst", CURVE_LEAST);
    double most = 0;
    bool ok = true;
    for (int i = 1; ok && i <= PLATES; i++) {
        double h = 0.05 * i, beyond = h / 10, depth = (CLOSED_LAMP_AT - h - 2) / 10;
        Scene scene = closed_wall_and_lamp(WIDE, HIGH);
        Probe probe;
        closed_plate(&scene, h, 0.6);
        ok = probe_begin(&probe, labs, LAB_ID, &scene, WIDE, HIGH) && draw(&probe, 0, 0);
        double wrong = 1.5 * depth * depth / 1024;
        if (ok) {
            curve_add(halves, h, most_false(&probe), wrong / (wrong + beyond * beyond), 1.0 / 255);
            findings_frame(findings, 0, most_false(&probe), &probe.truth_view, &probe.measured,
                           "16 bits, a plate at %.2f", h);
            most = fmax(most, most_false(&probe));
        }
        ok = ok && draw(&probe, 0, 1);
        wrong = 1e-6 + 1.5 * depth * depth / (1 << 23);
        if (ok)
            curve_add(floats, h, most_false(&probe), wrong / (wrong + beyond * beyond), 1.0 / 255);
        probe_end(&probe);
    }
    // One of the twelve variances is rounded up by a quarter of a step at least: even at the highest plate
    // that is 0.01.
    curve_add(worst, PLATES * 0.05, most, 0.01, 0);
    return ok;
}

const Row LAB_TABLE[] = {
    {100 * LAB_NUMBER + 1, "light bleeding", "two moments of depth",
     "the distance of two casters, 0.5 to 3 units",
     "Under a lower caster, b before the receiver, and the border of an upper one, a above it, the bound is "
     "up to "
     "a^2 / (a + 2 b)^2, at the share q = b / (a + 2 b) of the filter. A cut at that leaves nothing.",
     "closed form; A. Lauritzen: Summed-Area Variance Shadow Maps, GPU Gems 3, 2007", run_bleeding},
    {100 * LAB_NUMBER + 2, "16-bit moments", "two moments of depth", "the caster's height, 0.05 to 0.6 units",
     "The variance is a small difference of numbers near t^2. With 11 bits it is wrong by up to 1.5 t^2 / "
     "1024, and near "
     "casters get light in their umbra; with 24 bits they do not.",
     "closed form", run_halves},
    {0},
};
