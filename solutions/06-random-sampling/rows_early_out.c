// What an early-out misses. Lab 06 asks the eight outermost of its samples first, which lie beyond sqrt(3/4)
// of the disc's radius R, and believes them when they agree.
#include "truth/closed_scenes.h"
#include "stability/probe.h"
#include "stability/row.h"

enum { SIDE = 256, MAP = 1024, COLUMNS = 4, ROWS = 8, SAMPLES = COLUMNS * ROWS };
static const double radius = 0.4, half_size = 4, height = 2.5;

// A ball of radius b over a wall, under light from the left, 45 degrees aslant: its shadow is in the middle.
static Scene ball(double b) {
    Scene scene = closed_wall(6, 10, 2 * atanf(0.035F));
    closed_add(&scene, SHAPE_SPHERE, vec3_make((float)-height, 0, (float)height),
               vec3_make((float)b, (float)b, (float)b), 0);
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(-6, 0, 6), vec3_make(0, 0, 0), 0, (float)half_size, 1,
                 14);
    return scene;
}

// Area that two discs have in common, of that of the first, of radius 1; the other's radius is b, their
// distance d.
static double overlap(double b, double d) {
    if (d <= fabs(1 - b))
        return fmin(b * b, 1);
    if (d >= 1 + b)
        return 0;
    double a = acos((d * d + 1 - b * b) / (2 * d)), c = acos((d * d + b * b - 1) / (2 * d * b));
    return (a - sin(2 * a) / 2 + b * b * (c - sin(2 * c) / 2)) / GLM_PI;
}

// The truth is that of the disc, not of a point.
static void set_truth(Probe *probe, double b) {
    for (int i = 0; i < SIDE * SIDE; i++) {
        vec3s p = probe->truth_view.picture.hits[i].position;
        probe->truth_view.visibility[i] =
            (float)(1 - overlap(b / radius, hypot(p.x * M_SQRT1_2, p.y) / radius));
    }
}

// Mean error of the visibility within `reach` of the shadow's middle (in the light's cross-section).
static double middle_error(const Probe *probe, double reach) {
    double sum = 0, count = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        vec3s p = probe->truth_view.picture.hits[i].position;
        if (hypot(p.x * M_SQRT1_2, p.y) > reach)
            continue;
        sum += probe->measured.visibility[i] - probe->truth_view.visibility[i];
        count++;
    }
    return sum / count;
}

static bool draw(Probe *probe, Findings *findings, bool early_out, double b, double reach, double *error) {
    probe_knob(probe, "early-out", early_out);
    bool ok = probe_draw(probe);
    *error = ok ? middle_error(probe, reach) : 0;
    if (ok)
        findings_frame(findings, early_out ? 0 : 1, fabs(*error), &probe->truth_view, &probe->measured,
                       "A ball of %.2f R, %s early-out", b / radius, early_out ? "with" : "without");
    return ok;
}

static bool run_early_out(LabSet *labs, Findings *findings) {
    const double texel = 2 * half_size / MAP;
    Figure *figure = findings_figure(findings, "In the middle of a ball's shadow", "radius of the ball (R)",
                                     "error of the visibility");
    Curve *hasty = figure_curve(figure, "failure: early-out", CURVE_EQUAL);
    Curve *thorough = figure_curve(figure, "remedy: all samples", CURVE_EQUAL);
    bool ok = true;
    for (int i = 1; ok && i <= 10; i += i == 8 ? 2 : 1) {
        double b = 0.1 * i * radius, reach = i < 10 ? sqrt(0.75) * radius - b - texel : 0.02 * radius, error;
        const Scene scene = ball(b);
        Probe probe;
        ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE);
        if (ok)
            set_truth(&probe, b);
        probe_knob(&probe, "map size", MAP);
        probe_knob(&probe, "radius", radius / (2 * half_size) * MAP);
        probe_knob(&probe, "columns", COLUMNS);
        probe_knob(&probe, "rows", ROWS);
        probe_knob(&probe, "pattern size", 32);
        ok = ok && draw(&probe, findings, true, b, reach, &error);
        if (ok) // where all light is missed, the mean of b^2 over the middle is b^2
            curve_add(hasty, b / radius, error, i < 10 ? b * b / (radius * radius) : 0, i < 10 ? 1e-6 : 0.05);
        ok = ok && draw(&probe, findings, false, b, reach, &error);
        if (ok)
            curve_add(thorough, b / radius, error, 0, 0.05);
        probe_end(&probe);
    }
    return ok;
}

const Row LAB_TABLE[] = {
    {17, "early-out", "random sampling with early-out",
     "a ball before the light, from 0.1 to 1 of the disc's radius R",
     "A ball of less than 0.866 R in the middle lies inside the eight samples that are asked first: they "
     "agree on light, and the whole shadow, (b / R)^2, is missed. A ball as large as the disc is found. "
     "With all samples the error stays below 0.05.",
     "closed form; Y. Uralsky: Efficient Soft-Edged Shadows Using Pixel Shader Branching, GPU Gems 2, 2005",
     run_early_out},
    {0},
};
