// Where lab 04's cures are at their ends: light along the normal, thin boards, near planes close to the lamp.
#include "scene/count.h"
#include "stability/probe.h"
#include "stability/row.h"
#include "stability/tilted.h"

enum { WIDTH = 400, HEIGHT = 100, SIDE = 200, MAP = 512, CONSTANT = 1, FRONT_FACES = 4, NORMAL_OFFSET = 5 };
static const float half_size = 4;
static const double share_tolerance = 4.0 / WIDTH; // as in rows_bias.c
static const char share[] = "false shadow (share of the wall)";

// The normal offset alone, without what lab 04 adds for rounding.
static const Change bare_offset = {.name = "a normal offset without a bias for rounding",
                                   .edits = {{"shadow.frag", "ROUNDING = 1e-6", "ROUNDING = 0.0"}},
                                   .edit_count = 1};

static bool sweep_pole(LabSet *labs, Findings *findings, Curve *curve, const Change *change) {
    static const double angles[] = {1e-5, 1e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3, 1};
    bool ok = true;
    for (unsigned i = 0; ok && i < COUNT(angles); i++) {
        const Scene scene = tilted_wall(angles[i], 45, half_size, 1);
        Probe probe;
        ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE);
        probe.change = change;
        probe_knob(&probe, "method", NORMAL_OFFSET);
        probe_knob(&probe, "map size", MAP);
        probe_knob(&probe, "normal offset", 0.72);
        ok = ok && probe_draw(&probe);
        if (ok) {
            const double dark = probe.measured.metrics.all.false_shadow;
            curve_add(curve, angles[i], dark, 0, 0);
            findings_frame(findings, 0, dark, &probe.truth_view, &probe.measured,
                           "Normal offset, the light %g degrees from the normal", angles[i]);
        }
        probe_end(&probe);
    }
    return ok;
}

// The worst of a curve, as a curve of one point: that the failure shows somewhere.
static void add_worst(Curve *worst, const Curve *curve) {
    CurvePoint found = {0};
    for (int i = 0; i < curve->count; i++)
        if (curve->points[i].measured > found.measured)
            found = curve->points[i];
    curve_add(worst, found.x, found.measured, 1.0 / (SIDE * SIDE), 0);
}

static bool run_pole(LabSet *labs, Findings *findings) {
    Figure *figure =
        findings_figure(findings, "Light along the normal", "light's angle theta (degrees)", share);
    Curve *bare = figure_curve(figure, "failure: the worst of an offset alone", CURVE_LEAST),
          *cured = figure_curve(figure, "remedy: and a bias of 1e-6", CURVE_EQUAL);
    Curve alone = {0};
    figure->log_x = true;
    bool ok = sweep_pole(labs, findings, &alone, &bare_offset) && sweep_pole(labs, findings, cured, NULL);
    add_worst(bare, &alone);
    return ok;
}

// A board that fills the picture: its front faces are culled in the map, which holds its back instead,
// farther along the light by thickness / cos(theta).
static bool sweep_board(LabSet *labs, Findings *findings, Curve *curve, double psi, int method) {
    const double theta = 60;
    bool ok = true;
    for (int i = 1; ok && i <= 8; i++) {
        const double r = i < 7 ? 0.15 * i : i == 7 ? 1.1 : 1.5;
        Scene scene = tilted_wall(theta, psi, half_size, (double)WIDTH / HEIGHT);
        const double least = 0.5 * 2 * half_size / MAP * tilted_slope(&scene),
                     thickness = r * least * cos(closed_radians(theta));
        scene.object_count = 0;
        closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, (float)(-thickness / 2)),
                   vec3_make(6, 6, (float)(thickness / 2)), 0);
        Probe probe;
        ok = probe_begin(&probe, labs, LAB_ID, &scene, WIDTH, HEIGHT);
        probe_knob(&probe, "method", method);
        probe_knob(&probe, "map size", MAP);
        probe_knob(&probe, "normal offset", 0.72);
        ok = ok && probe_draw(&probe);
        if (ok) {
            const double dark = probe.measured.metrics.all.false_shadow;
            const bool cured = method == NORMAL_OFFSET;
            curve_add(curve, r, dark, cured ? 0 : tilted_acne(r, psi), cured || r > 1 ? 0 : share_tolerance);
            findings_frame(findings, 0, cured ? 0 : dark, &probe.truth_view, &probe.measured,
                           "A board %.4f thick, front faces culled", thickness);
        }
        probe_end(&probe);
    }
    return ok;
}

static bool run_board(LabSet *labs, Findings *findings) {
    Figure *figure =
        findings_figure(findings, "The lit face of a thin closed board",
                        "r = thickness / (s sin(theta) K / 2)", "false shadow (share of the face)");
    return sweep_board(labs, findings, figure_curve(figure, "failure: slope along an axis", CURVE_EQUAL), 0,
                       FRONT_FACES) &&
           sweep_board(labs, findings, figure_curve(figure, "failure: along the diagonal", CURVE_EQUAL), 45,
                       FRONT_FACES) &&
           sweep_board(labs, findings, figure_curve(figure, "remedy: normal offset instead", CURVE_EQUAL), 45,
                       NORMAL_OFFSET);
}

// A wall under a lamp at `distance`, tilted by 50 degrees, and a board that stands on it, across the light.
static const double distance = 5, far_plane = 20, height = 1, thickness = 0.02, slant = 50;

static Scene board_under_lamp(double near_plane) {
    Scene scene = tilted_wall(slant, 0, half_size, (double)WIDTH / 12);
    Light *light = &scene.lights[0];
    light->kind = LIGHT_SPOT;
    light->position = glms_vec3_scale(glms_vec3_normalize(light->position), (float)distance);
    light->fov_y = glm_rad(40);
    light->near_plane = (float)near_plane;
    light->far_plane = (float)far_plane;
    closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, (float)(height / 2)),
               vec3_make((float)(thickness / 2), 3, (float)(height / 2)), 0);
    scene.camera.fov_y = 2 * atanf(0.03F / scene.camera.eye.z);
    return scene;
}

// The lit stripe that begins at the board's foot, from the middle of the board: world units.
static double lit_stripe(const Probe *probe) {
    const int row = 6 * WIDTH;
    double lit = 0;
    for (int i = row; i < row + WIDTH; i++) {
        const TruthHit *hit = &probe->truth_view.picture.hits[i];
        if (hit->object == 0 && hit->position.x > 0 && probe->measured.visibility[i] > 0.5F)
            lit = fmax(lit, (double)hit->position.x);
    }
    return lit;
}

// How far the wall is lit under the board: there depths of board and wall, 1/d with factors, differ by the
// bias. By bisection, along the light through the middle of the board.
static double leak(const Light *light, double bias) {
    const double n = (double)light->near_plane, f = far_plane, x0 = (double)light->position.x,
                 z0 = (double)light->position.z;
    double low = 0, high = 3;
    for (int i = 0; i < 40; i++) {
        const double x = (low + high) / 2, at = (-thickness / 2 - x0) / (x - x0); // of the way to the wall
        const double wall = (-x0 * (x - x0) + z0 * z0) / distance, board = at * wall;
        *((1 / board - 1 / wall) * f * n / (f - n) < bias ? &low : &high) = x;
    }
    return low;
}

static bool run_leak(LabSet *labs, Findings *findings) {
    static const double bias = 1e-4;
    Figure *figure = findings_figure(findings, "Light under a board's foot, by a bias in depth",
                                     "the lamp's near plane (world units)", "lit as far as (world units)");
    Curve *gap = figure_curve(figure, "bias of 0.0001", CURVE_EQUAL);
    bool ok = true;
    figure->log_x = figure->log_y = true;
    for (int i = 0; ok && i < 10; i++) {
        const double near_plane = 0.004 * pow(1.25, i);
        const Scene scene = board_under_lamp(near_plane);
        Probe probe;
        ok = probe_begin(&probe, labs, LAB_ID, &scene, WIDTH, 12);
        probe_knob(&probe, "method", CONSTANT);
        probe_knob(&probe, "map size", 4096);
        probe_knob(&probe, "bias", bias);
        ok = ok && probe_draw(&probe);
        if (ok) {
            const double texel = 2 * distance * tan(closed_radians(20)) / 4096;
            curve_add(gap, near_plane, lit_stripe(&probe), leak(&scene.lights[0], bias),
                      texel / cos(closed_radians(slant)) + probe_unit(&probe));
            findings_frame(findings, 0, 1 / near_plane, &probe.truth_view, &probe.measured,
                           "A near plane at %.4f", near_plane);
        }
        probe_end(&probe);
    }
    return ok;
}

const Row LAB_TABLE[] = {
    {41, "light along the normal", "normal offset", "theta, 0.00001 to 1 degree",
     "The offset goes as sin(theta), and so does the wall's slope in the map; but near the pole the sine of "
     "rounded numbers is 0, and rounding decides which of two equal depths is the less. A bias of a dozen "
     "roundings of a float (6 * 2^-24, row 12) is more than all of them. No share of the wall may be dark.",
     "closed form", run_pole},
    {42, "thin boards", "front-face culling", "a closed board's thickness, 0.15 to 1.5 times the least one",
     "The map holds the board's back, farther along the light by its thickness / cos(theta), which serves as "
     "a "
     "bias for its lit face: as row 2, with r = thickness / (s sin(theta) K / 2). A board thinner than "
     "that has acne on its lit face. A normal offset needs no thickness.",
     "closed form", run_board},
    {47, "near plane and leaks", "constant bias in depth", "the lamp's near plane n, 0.004 to 0.03",
     "A bias b in depth is about b d^2 (f - n) / (f n) in the world, as 1 / n. Exactly: the wall is lit "
     "under "
     "the board as far as to where (1 / d_board - 1 / d_wall) f n / (f - n) = b. The tolerance is a texel on "
     "the wall and a pixel.",
     "closed form", run_leak},
    {0},
};
