// What the cures of acne cost where a caster touches its receiver. A board stands on a wall, across the
// light, which comes from the left: all rows of the picture are alike.
#include "stability/probe.h"
#include "stability/row.h"
#include "stability/tilted.h"

enum { WIDTH = 800, ROWS = 12, MAP = 1024, CONSTANT = 1, FRONT_FACES = 4, NORMAL_OFFSET = 5 };
static const float half_size = 4, height = 1;
static const double theta = 50;

static Scene board(double angle, float thickness) {
    Scene scene = tilted_wall(angle, 0, half_size, (double)WIDTH / ROWS);
    closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, height / 2), vec3_make(thickness / 2, 3, height / 2), 0);
    return scene;
}

static bool begin(Probe *probe, LabSet *labs, const Scene *scene, int method) {
    bool ok = probe_begin(probe, labs, LAB_ID, scene, WIDTH, ROWS);
    probe_knob(probe, "method", method);
    probe_knob(probe, "map size", MAP);
    probe_knob(probe, "bias", 0);
    return ok;
}

// The part of the wall between two places in the middle row that is lit, world units.
static double lit_length(const Probe *probe, double left, double right) {
    double lit = 0;
    for (int i = WIDTH * (ROWS / 2); i < WIDTH * (ROWS / 2 + 1); i++) {
        const TruthHit *hit = &probe->truth_view.picture.hits[i];
        if (hit->object == 0 && hit->position.x > left && hit->position.x < right)
            lit += probe->measured.visibility[i];
    }
    return lit * probe_unit(probe);
}

// A map knows an edge to half a texel, which a tilted light draws out on the wall, and a length of pixels has
// two ends.
static double length_tolerance(const Probe *probe, double stretch) {
    return 2 * half_size / MAP / 2 * stretch + probe_unit(probe);
}

static bool sweep_tip(LabSet *labs, Findings *findings, Figure *figure) {
    const double offset = 40, thickness = 0.1;
    Curve *tip = figure_curve(figure, "40 texels: the tip's shift", CURVE_EQUAL);
    Curve *gap = figure_curve(figure, "40 texels: gap at the foot", CURVE_EQUAL);
    bool ok = true;
    for (int angle = 20; ok && angle <= 65; angle += 9) {
        const Scene scene = board(angle, (float)thickness);
        double slope = tan(closed_radians(angle)), length = height * slope;
        double delta = offset * 2 * half_size / MAP * sin(closed_radians(angle));
        Probe probe;
        ok = begin(&probe, labs, &scene, NORMAL_OFFSET);
        probe_knob(&probe, "normal offset", offset);
        ok = ok && probe_draw(&probe);
        if (ok) {
            double foot = thickness / 2 + 0.03, middle = thickness / 2 + length / 2,
                   end = thickness / 2 + length;
            curve_add(tip, angle, lit_length(&probe, middle, end), delta * slope,
                      length_tolerance(&probe, 1 / cos(closed_radians(angle))));
            curve_add(gap, angle, lit_length(&probe, foot, middle), 0, 0);
            findings_frame(findings, 1, delta * slope, &probe.truth_view, &probe.measured,
                           "A board under light at %d degrees, normal offset of %.0f texels", angle, offset);
        }
        probe_end(&probe);
    }
    return ok;
}

// Along the diagonal, where a normal offset of s sin(theta) / sqrt 2 is needed.
static bool sweep_angle(LabSet *labs, Findings *findings, Curve *curve, double offset, double expected) {
    enum { SIDE = 200 };
    bool ok = true;
    for (int angle = 0; ok && angle <= 85; angle += angle < 80 ? 16 : 5) {
        const Scene scene = tilted_wall(angle, 45, half_size, 1);
        Probe probe;
        ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE);
        probe_knob(&probe, "method", NORMAL_OFFSET);
        probe_knob(&probe, "map size", 512);
        probe_knob(&probe, "normal offset", offset);
        ok = ok && probe_draw(&probe);
        if (ok) {
            double dark = probe.measured.metrics.all.false_shadow;
            bool bare = angle > 0 && expected > 0; // straight light: no slope, no acne
            curve_add(curve, angle, dark, bare ? expected : 0, bare ? 2.0 / SIDE : 0);
            findings_frame(findings, 0, dark, &probe.truth_view, &probe.measured,
                           "Normal offset of %.2f texels, light at %d degrees", offset, angle);
        }
        probe_end(&probe);
    }
    return ok;
}

static bool run_normal_offset(LabSet *labs, Findings *findings) {
    Figure *bare = findings_figure(findings, "On a bare wall", "light's angle theta (degrees)",
                                   "false shadow (share of the wall)");
    Figure *cost = findings_figure(findings, "Behind a board", "light's angle theta (degrees)",
                                   "false light (world units)");
    return sweep_angle(labs, findings, figure_curve(bare, "0.72 texels", CURVE_EQUAL), 0.72, 0) &&
           sweep_angle(labs, findings, figure_curve(bare, "half of 1 / sqrt 2", CURVE_EQUAL), 0.5 * M_SQRT1_2,
                       tilted_acne(0.5, 45)) &&
           sweep_tip(labs, findings, cost);
}

// Where the wall begins to the right of the board, as the eye sees it over the board's upper edge.
static double seen_foot(const Probe *probe, double thickness) {
    double distance = probe->truth_view.truth.scene.camera.eye.z;
    return thickness / 2 * distance / (distance - height);
}

// Draws, and measures the lit stripe that begins there: how far it reaches, from the board's lit face.
static bool measure_gap(Probe *probe, double thickness, double *gap) {
    double foot = seen_foot(probe, thickness);
    int lit = 0;
    if (!probe_draw(probe))
        return false;
    for (int i = WIDTH * (ROWS / 2); i < WIDTH * (ROWS / 2 + 1); i++) {
        const TruthHit *hit = &probe->truth_view.picture.hits[i];
        if (hit->object != 0 || hit->position.x < foot)
            continue;
        if (probe->measured.visibility[i] < 0.5F)
            break;
        lit++;
    }
    *gap = lit ? lit * probe_unit(probe) + foot + thickness / 2 : 0;
    return true;
}

static bool run_gap(LabSet *labs, Findings *findings) {
    const double thickness = 0.04, sine = sin(closed_radians(theta)), cosine = cos(closed_radians(theta));
    const Scene scene = board(theta, (float)thickness);
    Figure *figure =
        findings_figure(findings, "Gap at the foot of a board", "bias (world units along the light)",
                        "lit as far from the lit face (world units)");
    Curve *constant = figure_curve(figure, "constant bias", CURVE_EQUAL);
    Curve *normal = figure_curve(figure, "remedy: normal offset instead", CURVE_EQUAL);
    Probe probe;
    double gap;
    bool ok = begin(&probe, labs, &scene, CONSTANT);
    for (int i = 1; ok && i <= 8; i++) {
        double bias = 0.1 * i;
        probe_knob(&probe, "method", CONSTANT);
        probe_knob(&probe, "bias", bias / (TILTED_FAR - TILTED_NEAR));
        ok = measure_gap(&probe, thickness, &gap);
        if (!ok)
            break;
        curve_add(constant, bias, gap, bias * sine, length_tolerance(&probe, cosine));
        findings_frame(findings, 0, bias, &probe.truth_view, &probe.measured, "A constant bias of %.1f",
                       bias);
        probe_knob(&probe, "method", NORMAL_OFFSET);
        probe_knob(&probe, "normal offset", bias / (2 * half_size / MAP) * cosine / sine);
        ok = measure_gap(&probe, thickness, &gap);
        curve_add(normal, bias, gap, 0, 0);
    }
    probe_end(&probe);
    return ok;
}

static bool sweep_thickness(LabSet *labs, Findings *findings, Figure *figure) {
    const double bias = 0.4, sine = sin(closed_radians(theta)), cosine = cos(closed_radians(theta));
    Curve *constant = figure_curve(figure, "failure: constant bias of 0.4", CURVE_EQUAL);
    Curve *culled = figure_curve(figure, "remedy: front faces culled", CURVE_EQUAL);
    bool ok = true;
    for (int i = 0; ok && i <= 7; i++) {
        double thickness = 0.01 + 0.06 * i, gap;
        const Scene scene = board(theta, (float)thickness);
        Probe probe;
        ok = begin(&probe, labs, &scene, FRONT_FACES) && measure_gap(&probe, thickness, &gap);
        if (ok)
            curve_add(culled, thickness / sine, gap, 0, 0);
        probe_knob(&probe, "method", CONSTANT);
        probe_knob(&probe, "bias", bias / (TILTED_FAR - TILTED_NEAR));
        ok = ok && measure_gap(&probe, thickness, &gap);
        if (ok) {
            double reach = bias * sine, foot = thickness / 2 + seen_foot(&probe, thickness);
            curve_add(constant, thickness / sine, gap, reach > foot ? reach : 0,
                      length_tolerance(&probe, cosine));
            findings_frame(findings, 0, gap, &probe.truth_view, &probe.measured,
                           "A board %.2f thick under a constant bias of 0.4", thickness);
        }
        probe_end(&probe);
    }
    return ok;
}

// A single quad over the wall, its front towards the light or away from it.
static Scene quad(bool away) {
    Scene scene = tilted_wall(theta, 0, half_size, 1);
    mat4s placed = glms_translate_make(vec3_make(-1, 0, 1.5F));
    closed_add(&scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(0.8F, 1, 0.8F), 0);
    mat4s *world = &scene.objects[1].world_from_object;
    *world = glms_mat4_mul(glms_rotate(placed, glm_rad(away ? -90 : 90), vec3_make(1, 0, 0)), *world);
    return scene;
}

static const Change both_faces = {.name = "no face is culled in the map",
                                  .edits = {{"lab.c", "glCullFace(GL_FRONT);", "glDisable(GL_CULL_FACE);"},
                                            {"lab.c", "glCullFace(GL_BACK);", "glEnable(GL_CULL_FACE);"}},
                                  .edit_count = 2};

// Of the inside of the quad's shadow all is lit, or none.
static bool add_quad(LabSet *labs, Findings *findings, Curve *curve, bool away, const Change *change,
                     double expected) {
    enum { SIDE = 200 };
    const Scene scene = quad(away);
    Probe probe;
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE);
    probe.change = change;
    probe_knob(&probe, "method", change || curve->name[0] == 'f' ? FRONT_FACES : CONSTANT);
    probe_knob(&probe, "map size", MAP);
    ok = ok && probe_draw(&probe);
    if (ok) {
        curve_add(curve, away, probe_false(&probe, 0, 1), expected, 0);
        findings_frame(findings, 1, probe.measured.metrics.all.false_light, &probe.truth_view,
                       &probe.measured, "A single quad that faces %s the light: %s", away ? "away from" : "",
                       curve->name);
    }
    probe_end(&probe);
    return ok;
}

static bool add_quads(LabSet *labs, Findings *findings, Curve *curve, const Change *change,
                      const double expected[2]) {
    return add_quad(labs, findings, curve, false, change, expected[0]) &&
           add_quad(labs, findings, curve, true, change, expected[1]);
}

static bool run_front_faces(LabSet *labs, Findings *findings) {
    Figure *box = findings_figure(findings, "A closed board", "its thickness along the light (world units)",
                                  "lit as far from its lit face (world units)");
    Figure *single =
        findings_figure(findings, "A single quad", "0: its front faces the light, 1: its back does",
                        "false light (share of its shadow)");
    return sweep_thickness(labs, findings, box) &&
           add_quads(labs, findings, figure_curve(single, "front faces culled", CURVE_EQUAL), NULL,
                     (const double[]){1, 0}) &&
           add_quads(labs, findings, figure_curve(single, "back faces culled", CURVE_EQUAL), NULL,
                     (const double[]){0, 1}) &&
           add_quads(labs, findings, figure_curve(single, "remedy: no face culled", CURVE_EQUAL), &both_faces,
                     (const double[]){0, 0});
}

const Row LAB_TABLE[] = {
    {6, "normal offset", "normal offset",
     "the light's angle theta: 0 to 85 degrees on a bare wall, 20 to 65 at a board",
     "No acne at any angle with 0.72 texels (1 / sqrt 2 is enough along the diagonal), an eighth of the "
     "wall with half of that at every angle: unlike a depth bias it need not grow with the slope. The price "
     "of an offset delta is the shadow's tip, which moves by delta tan(theta); the foot keeps its shadow.",
     "closed form", run_normal_offset},
    {7, "peter-panning", "constant bias", "the bias b, 0.1 to 0.8 world units along the light",
     "The wall is lit as far as b sin(theta) from the board's lit face. A normal offset that moves the "
     "comparison as far leaves no gap.",
     "closed form", run_gap},
    {8, "thin casters", "front-face culling", "a closed board's thickness towards 0; then a single quad",
     "A constant bias b lights the wall as far as b sin(theta) from the board's lit face. Under a thick "
     "board that is out of sight; it shows on the dark side as soon as the board's thickness along the "
     "light is less than b. With the front faces culled the map holds the dark side itself, and nothing "
     "leaks however thin a closed board is. But a single quad has one face only: culled with it goes its "
     "whole shadow, and only a map without culling holds it from both sides (at the price of acne again).",
     "closed form", run_front_faces},
    {0},
};
