// Where a march through the dust errs, and that the faces of the volumes do not.
#include "scene/count.h"
#include "stability/probe.h"
#include "stability/row.h"
#include "stability/sight.h"
#include "truth/closed_scenes.h"

enum { SIDE = 160, MAP = 2048, MARCH = 1, FACES = 2 };
static const float reach = 9;          // half the map's side
static const float screen_edge = 8.5f; // z of a screen whose shadow has one border before the wall
static const Medium medium = {0.1f, 0.06f};
static const double most_rounding = 0.5 / 255; // of the picture

static const Change no_clamp = {.name = "no depth clamp",
                                .edits = {{"lab.c", "glEnable(GL_DEPTH_CLAMP)", "glDisable(GL_DEPTH_CLAMP)"}},
                                .edit_count = 1};
static const Change each_counts = {
    .name = "each shadow counts",
    .edits = {{"merge.frag", "from = next.y", "next.x = 0.0"},
              {"merge.frag", "if (shadow.y > from && shadow.x < next.x)", "if (caster == i)"}},
    .edit_count = 2};

// A wall at z = 0, seen from (0, 0, 10), and a sun from +x, turned by `slope` (dz / dx of its rays).
static Scene dusty_wall(float slope) {
    Scene scene = closed_wall(20, 10, glm_rad(40));
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(10, 0, 5 + 10 * slope), vec3_make(0, 0, 5), 0, reach, 1,
                 30);
    scene.medium = medium;
    return scene;
}

// A thin plate at x, high enough for all rays, that keeps the sun from z = near to z = far there.
static void add_screen(Scene *scene, float x, float low_z, float high_z) {
    closed_add(scene, SHAPE_BOX, vec3_make(x, 0, (low_z + high_z) / 2),
               vec3_make(1e-4f, 6, (high_z - low_z) / 2), 0);
}

// The sum of e^(-extinction t) between two distances, of this row's dust.
static double sent(double from, double to) {
    double a = medium.extinction;
    return medium.scattering * (exp(-a * from) - exp(-a * to)) / a;
}

// A pixel's ray through the dust, lit up to one border: how far it is, and how long the whole ray.
typedef struct Border {
    double at, way;
} Border;

static Border find_border(const Scene *scene, int pixel, float slope) {
    vec3s ray = sight_ray(&scene->camera, (MetricsSize){SIDE, SIDE}, pixel % SIDE, pixel / SIDE);
    const float x = 4.5f, z = screen_edge; // the screen's edge; the border is where z - slope x is as there
    double depth = ((double)z - 10 - (double)(slope * x)) / (double)(ray.z - slope * ray.x);
    double length = glms_vec3_norm(ray);
    return (Border){depth * length, 10 * length};
}

// The error of a sum whose samples lie at `place` (0..1) in the steps.
static double error_at(Border border, int steps, double place) {
    double step = border.way / steps, sum = 0;
    for (int i = 0; i < steps && (i + place) * step <= border.at; i++)
        sum += medium.scattering * exp(-(double)medium.extinction * (i + place) * step) * step;
    return sum - sent(0, border.at);
}

typedef struct Spread {
    double size, square; // means of the error's size and of its square
} Spread;

// With jitter any place is as likely as another; else it is the middle.
static Spread expected_error(Border border, int steps, bool jitter) {
    enum { PLACES = 32 };
    Spread spread = {fabs(error_at(border, steps, 0.5)), 0};
    for (int i = 0; jitter && i < PLACES; i++) {
        double error = error_at(border, steps, (i + 0.5) / PLACES);
        spread.size = (i ? spread.size : 0) + fabs(error) / PLACES;
        spread.square += error * error / PLACES;
    }
    return spread;
}

// Sums over the pixels that count.
typedef struct Sums {
    double size, expected, error, square, step, count;
} Sums;

static Sums sum_errors(const Probe *probe, float slope, int steps, bool jitter) {
    Sums sums = {0};
    for (int i = 0; i < SIDE * SIDE; i++) {
        if (!probe->measured.mask[i])
            continue;
        Border border = find_border(&probe->truth_view.truth.scene, i, slope);
        Spread spread = expected_error(border, steps, jitter);
        double error = (double)probe->measured.visibility[i] - (double)probe->truth_view.visibility[i];
        sums.size += fabs(error), sums.error += error, sums.count++;
        sums.expected += spread.size, sums.square += spread.square;
        sums.step += medium.scattering * border.way / steps;
    }
    return sums;
}

// A texel on the border takes or gives a sample: the share of a step that a texel is, of a step.
static bool add_march(LabSet *labs, Findings *findings, Curve *curves[5], int steps) {
    const float slope = 0.8f;
    Scene scene = dusty_wall(slope);
    Probe probe;
    add_screen(&scene, 4.5f, -9, screen_edge);
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE);
    probe_knob(&probe, "dust", MARCH);
    probe_knob(&probe, "steps", steps);
    probe_knob(&probe, "map size", MAP);
    for (int jitter = 0; ok && jitter < 2; jitter++) {
        probe_knob(&probe, "jitter", jitter);
        ok = probe_draw(&probe);
        if (!ok)
            break;
        Sums sums = sum_errors(&probe, slope, steps, jitter);
        double standard = sqrt(sums.square) / sums.count, size = sums.size / sums.count;
        double texel = sums.step / sums.count * 2 * (double)reach / MAP * steps / 10;
        double tolerance = texel + 4 * standard * jitter + most_rounding;
        curve_add(curves[jitter], steps, size, sums.expected / sums.count, tolerance);
        curve_add(curves[2 + jitter], steps, size, 0, 0);
        findings_frame(findings, jitter, size, &probe.truth_view, &probe.measured, "%d steps, %s", steps,
                       jitter ? "jitter" : "no jitter");
        if (jitter)
            curve_add(curves[4], steps, sums.error / sums.count, 0, 4 * standard + texel + most_rounding / 2);
    }
    probe_end(&probe);
    return ok;
}

static bool run_march(LabSet *labs, Findings *findings) {
    Figure *sizes = findings_figure(findings, "Error of a march", "steps", "mean error (of the light)"),
           *means = findings_figure(findings, "Bias of the jitter", "steps", "mean, with its sign");
    sizes->log_x = sizes->log_y = means->log_x = true;
    Curve *curves[] = {
        figure_curve(sizes, "middle of the steps", CURVE_EQUAL), figure_curve(sizes, "jitter", CURVE_EQUAL),
        figure_curve(sizes, "middle: slope -1", CURVE_SLOPE),
        figure_curve(sizes, "jitter: slope -1", CURVE_SLOPE), figure_curve(means, "jitter", CURVE_EQUAL)};
    const int steps[] = {4, 6, 8, 11, 16, 23, 32};
    bool ok = true;
    for (int i = 2; i < 4; i++)
        curves[i]->slope = -1, curves[i]->tolerance = 0.1;
    for (size_t i = 0; ok && i < COUNT(steps); i++)
        ok = add_march(labs, findings, curves, steps[i]);
    return ok;
}

// Draws by faces, and keeps the frame where it is the worst.
static bool draw_faces(Probe *probe, const Change *change, Findings *findings, int slot,
                       const char *caption) {
    probe->change = change;
    probe_knob(probe, "dust", FACES);
    if (!probe_draw(probe))
        return false;
    findings_frame(findings, slot, probe->measured.metrics.all.mae, &probe->truth_view, &probe->measured,
                   "%s", caption);
    return true;
}

// The mean over the pixels that count of what is sent from depth `from` to depth `to`.
static double mean_sent(const Probe *probe, double from, double to) {
    double sum = 0, count = 0;
    for (int i = 0; i < SIDE * SIDE; i++)
        if (probe->measured.mask[i]) {
            double length = glms_vec3_norm(sight_ray(&probe->truth_view.truth.scene.camera,
                                                     (MetricsSize){SIDE, SIDE}, i % SIDE, i / SIDE));
            sum += sent(from * length, to * length);
            count++;
        }
    return sum / count;
}

// A screen 1.5 thick is moved from the wall to behind the eye.
static bool add_moved(LabSet *labs, Findings *findings, Curve *good, float middle) {
    Scene scene = dusty_wall(0);
    Probe probe;
    add_screen(&scene, 5, middle - 0.75f, middle + 0.75f);
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE) &&
              draw_faces(&probe, NULL, findings, 2, "by faces, as it should be");
    if (ok)
        curve_add(good, middle, probe.measured.metrics.all.mae, 0, most_rounding);
    probe_end(&probe);
    return ok;
}

// The shadow is 1 to 2 before the eye. A near plane behind its first face takes the number at which the ray
// enters, so the shadow begins at the eye; behind both it takes the shadow.
static bool add_near(LabSet *labs, Findings *findings, Curve *good, Curve *failure, float near_plane) {
    Scene scene = dusty_wall(0);
    Probe probe;
    scene.camera.near_plane = near_plane;
    add_screen(&scene, 5, 8, 9);
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE) &&
              draw_faces(&probe, NULL, findings, 2, "by faces, as it should be");
    if (ok)
        curve_add(good, near_plane, probe.measured.metrics.all.mae, 0, most_rounding);
    ok = ok && draw_faces(&probe, &no_clamp, findings, 0, "The near plane cuts a shadow's faces");
    if (ok) {
        double wrong = near_plane < 1   ? 0
                       : near_plane < 2 ? mean_sent(&probe, 0, 1)
                                        : mean_sent(&probe, 1, 2);
        curve_add(failure, near_plane, probe.measured.metrics.all.mae, wrong, most_rounding);
    }
    probe_end(&probe);
    return ok;
}

// Screens behind each other, in one shadow.
static bool add_screens(LabSet *labs, Findings *findings, Curve *good, Curve *failure, int count) {
    Scene scene = dusty_wall(0);
    Probe probe;
    for (int i = 0; i < count; i++)
        add_screen(&scene, 5 + 0.4f * (float)i, 4, 5);
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE) &&
              draw_faces(&probe, NULL, findings, 2, "by faces, as it should be");
    if (ok)
        curve_add(good, count, probe.measured.metrics.all.mae, 0, most_rounding);
    ok = ok && draw_faces(&probe, &each_counts, findings, 1, "Screens in one shadow, each of which counts");
    if (ok)
        curve_add(failure, count, probe.measured.metrics.all.mae, (count - 1) * mean_sent(&probe, 5, 6),
                  most_rounding);
    probe_end(&probe);
    return ok;
}

static bool run_faces(LabSet *labs, Findings *findings) {
    Figure *moved = findings_figure(findings, "A shadow moves over the eye", "z of its middle (the eye: 10)",
                                    "mean error (of the light)"),
           *near = findings_figure(findings, "The near plane cuts a shadow from 1 to 2", "near plane (units)",
                                   "mean error (of the light)"),
           *once = findings_figure(findings, "Screens in one shadow", "screens", "mean error (of the light)");
    Curve *curves[] = {
        figure_curve(moved, "by faces", CURVE_EQUAL), figure_curve(near, "with GL_DEPTH_CLAMP", CURVE_EQUAL),
        figure_curve(near, "failure: without", CURVE_EQUAL), figure_curve(once, "dark once", CURVE_EQUAL),
        figure_curve(once, "failure: each counts", CURVE_EQUAL)};
    const float nears[] = {0.1f, 0.5f, 0.9f, 1.1f, 1.5f, 1.9f, 2.1f, 3, 5};
    bool ok = true;
    for (int i = 0; ok && i < 12; i++)
        ok = add_moved(labs, findings, curves[0], 1.3f + 0.9f * (float)i);
    for (size_t i = 0; ok && i < COUNT(nears); i++)
        ok = add_near(labs, findings, curves[1], curves[2], nears[i]);
    for (int count = 1; ok && count <= 6; count++)
        ok = add_screens(labs, findings, curves[3], curves[4], count);
    return ok;
}

const Row LAB_TABLE[] = {
    {100 * LAB_NUMBER + 1, "march through dust", "in-scattered light by steps and a shadow map",
     "4 to 32 steps, in the middle of each and with jitter",
     "Each border of a shadow is missed by a part of the step it lies in: by half a step at most in the "
     "middle of "
     "the steps, and at random with jitter. Both errors fall with the number of steps (slope -1). With "
     "jitter the "
     "mean over many pixels is right.",
     "closed form: the border's place in its step", run_march},
    {100 * LAB_NUMBER + 2, "dust by faces", "in-scattered light by the faces of shadow volumes",
     "a shadow moved over the eye; the near plane through a shadow; 1 to 6 casters in one shadow",
     "Between the faces the light is a difference of exponentials, exact to the picture's 255 steps, the eye "
     "inside "
     "included. A near plane that cuts faces away takes the number at which a ray enters the shadow. Shadows "
     "in "
     "each other count once when their intervals are merged, else each for itself.",
     "closed form: (1 - e^(-a d)) / a; Max: Atmospheric Illumination and Shadows, SIGGRAPH 1986", run_faces},
    {0},
};
