// Where flattened casters break: past the lamp and the receiver, on each other, and in the receiver's own
// depth.
#include "scene/count.h"
#include "stability/probe.h"
#include "stability/row.h"
#include "truth/closed_scenes.h"

#include <string.h>

enum { SIDE = 160 };
static const vec3s lamp = {{-1.5f, 0, 4}};

static const Change by_hand = {
    .name = "divided by w by hand",
    .edits = {{"flat.vert", "u_clip_from_world * (u_flat_from_world * position_world)",
               "u_clip_from_world * vec4((u_flat_from_world * position_world).xyz / (u_flat_from_world * "
               "position_world).w, 1.0)"}},
    .edit_count = 1};
static const Change unclipped = {.name = "no clip distance",
                                 .edits = {{"flat.vert", "dot(u_plane[0], position_world)", "1.0"}},
                                 .edit_count = 1};
static const Change twice = {.name = "no mark of what is dark",
                             .edits = {{"lab.c", "glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT)",
                                        "glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP)"}},
                             .edit_count = 1};
static const Change no_offset = {
    .name = "no offset",
    .edits = {{"lab.c", "glEnable(GL_POLYGON_OFFSET_FILL)", "glDisable(GL_POLYGON_OFFSET_FILL)"}},
    .edit_count = 1};

// A wall and a lamp before it.
static Scene lit_wall(void) {
    Scene scene = closed_wall(6, 10, glm_rad(40));
    closed_light(&scene, LIGHT_POINT, lamp, vec3_make(lamp.x, 0, 0), 1, 0, 1, 20);
    return scene;
}

static void add_plate(Scene *scene, vec3s center, float half) {
    closed_add(scene, SHAPE_BOX, center, vec3_make(half, half, 1e-5f), 0);
}

// Draws with the change, and keeps the frame where it is the worst.
static bool draw(Probe *probe, const Change *change, Findings *findings, int slot, const char *caption) {
    probe->change = change;
    if (!probe_draw(probe))
        return false;
    findings_frame(findings, slot, probe->measured.metrics.all.mae, &probe->truth_view, &probe->measured,
                   "%s", caption);
    return true;
}

// A square plate at a height: over the lamp or behind the wall it throws nothing. The line from it through
// the lamp meets the wall in a square of side a H / |H - z|.
static bool add_past(LabSet *labs, Findings *findings, Curve *good, Curve *failure, float height) {
    const float half = 0.3f;
    Scene scene = lit_wall();
    Probe probe;
    add_plate(&scene, vec3_make(-2, 0, height), half);
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE) &&
              draw(&probe, NULL, findings, 1, "as it should be");
    if (ok) {
        double pixels = (double)probe.measured.metrics.all.pixels, unit = closed_unit(&scene, SIDE);
        double side = 2 * half * lamp.z / fabsf(lamp.z - height) / unit;
        curve_add(good, height, probe.measured.metrics.all.mae, 0, (2 + side / 16) / pixels);
        if (height < 0 || height > lamp.z) {
            ok = draw(&probe, height < 0 ? &unclipped : &by_hand, findings, 0,
                      height < 0 ? "A plate behind the wall, without a clip distance"
                                 : "A plate over the lamp, divided by w by hand");
            curve_add(failure, height, probe.measured.metrics.all.false_shadow, side * side / pixels,
                      (2 * side + 4) / pixels);
        }
    }
    probe_end(&probe);
    return ok;
}

// Plates in one shadow: with both faces of each, 2 k of them would take the light 2 k times.
static bool add_stack(LabSet *labs, Findings *findings, Curve *good, Curve *failure, int count) {
    const double opacity = 0.12;
    Scene scene = lit_wall();
    Probe probe;
    for (int i = 0; i < count; i++) {
        float t = 0.5f - 0.08f * (float)i; // of the way from the lamp to the shadow's middle
        add_plate(&scene, glms_vec3_lerp(lamp, vec3_make(1, 0, 0), t), t * 0.8f);
    }
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE);
    probe_knob(&probe, "opacity", opacity);
    ok = ok && draw(&probe, NULL, findings, 1, "as it should be");
    if (ok)
        curve_add(good, count, 1 - probe_false(&probe, 0, 1), opacity, 0.5 / 255);
    ok = ok && draw(&probe, &twice, findings, 1, "Each face takes the light again");
    if (ok) // what 255 steps make of it: half a step
        curve_add(failure, count, 1 - probe_false(&probe, 0, 1), fmin(1, 2 * count * opacity), 0.5 / 255);
    probe_end(&probe);
    return ok;
}

// The wall turned by degrees: shadow and wall have the same depth, but for rounding.
static bool add_turned(LabSet *labs, Findings *findings, Curve *good, Curve *failure, int degrees) {
    Scene scene = lit_wall();
    Probe probe;
    mat4s turned = glms_rotate_make(glm_rad((float)degrees), vec3_make(0, 1, 0));
    scene.objects[0].world_from_object = glms_mat4_mul(turned, scene.objects[0].world_from_object);
    add_plate(&scene, vec3_make(-0.6f, 0, 2), 0.5f);
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE) &&
              draw(&probe, NULL, findings, 1, "as it should be");
    if (ok)
        curve_add(good, degrees, probe_false(&probe, 0, 1), 0, 1e-6);
    ok =
        ok && draw(&probe, &no_offset, findings, 2, "Without an offset shadow and wall fight for each pixel");
    if (ok)
        curve_add(failure, degrees, probe_false(&probe, 0, 1), 0.01, 0);
    probe_end(&probe);
    return ok;
}

static bool run_planar(LabSet *labs, Findings *findings) {
    Figure *past = findings_figure(findings, "Past the lamp, behind the wall",
                                   "height of a plate (the lamp: 4)", "false shadow (share of the wall)"),
           *stack = findings_figure(findings, "Shadows on each other", "plates", "light taken"),
           *depth = findings_figure(findings, "Shadow and wall in one place", "turn of the wall (degrees)",
                                    "false light in the shadow");
    const char *names[] = {"between wall and lamp only",  "failure: not clipped", "taken once",
                           "failure: taken by each face", "with an offset",       "failure: without"};
    Curve *curves[] = {
        figure_curve(past, names[0], CURVE_EQUAL),  figure_curve(past, names[1], CURVE_EQUAL),
        figure_curve(stack, names[2], CURVE_EQUAL), figure_curve(stack, names[3], CURVE_EQUAL),
        figure_curve(depth, names[4], CURVE_EQUAL), figure_curve(depth, names[5], CURVE_LEAST)};
    const float heights[] = {-3, -2, -1, 0.5f, 1, 2, 6, 7, 8};
    bool ok = true;
    for (size_t i = 0; ok && i < COUNT(heights); i++)
        ok = add_past(labs, findings, curves[0], curves[1], heights[i]);
    for (int count = 1; ok && count <= 5; count++)
        ok = add_stack(labs, findings, curves[2], curves[3], count);
    for (int degrees = -40; ok && degrees <= 20; degrees += 15)
        ok = add_turned(labs, findings, curves[4], curves[5], degrees);
    return ok;
}

const Row LAB_TABLE[] = {
    {30, "planar shadows", "casters flattened onto a wall",
     "a plate's height past the lamp and behind the wall; 1 to 5 plates in one shadow; the wall's turn",
     "The projection's w is P.L - P.v for the plane P, the light L and the point v. What lies behind the "
     "wall "
     "throws a false shadow of known area unless a clip distance keeps it out; what lies higher than the "
     "lamp "
     "does when one divides by w by hand, for OpenGL clips a negative w. Each face takes the light again "
     "unless "
     "the stencil lets a pixel through once. Without an offset shadow and wall fight for each pixel.",
     "closed form: areas of squares; Blinn: Me and My (Fake) Shadow, IEEE CG&A 1988", run_planar},
    {0},
};
