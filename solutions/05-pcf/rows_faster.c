// Maps that are drawn less: one that is kept while nothing moves, and one of what casts alone. A wall is seen
// straight on; a board behind the camera throws a square on it, under light that is square to both.
#include "study_filters.h"
#include "scene/check.h"
#include "truth/closed_scenes.h"
#include "stability/probe.h"
#include "stability/row.h"

#include <string.h>

enum { SIDE = 128, MAP = 256, LINEAR = 2 };
static const float half_board = 0.5f,
                   shift = 1.5f; // more than the board is wide: the shadows lie side by side

// The kept map's edit, and none of what it asks before it keeps.
static const Change always_kept = {
    .name = "the map is kept whatever moves",
    .edits = {{"lab.c", "    ShadowMap map;\n", "    ShadowMap map;\n    bool kept;\n"},
              {"lab.c", "    shadow_map_destroy(&state.map);\n",
               "    shadow_map_destroy(&state.map);\n    state.kept = false;\n"},
              {"lab.c", "    shadow_map_begin(&state.map);\n",
               "    if (state.kept)\n        return;\n    state.kept = true;\n"
               "    shadow_map_begin(&state.map);\n"}},
    .edit_count = 3};

// What changes from the frame before, in this order.
enum { NOTHING_YET, CAMERA_MOVES, BOARD_MOVES, LIGHT_MOVES, NOTHING_MOVES, STEPS };

// A sheet is a plane, which only a map of all objects has.
static Scene at_step(int step, bool sheet) {
    const float board = step >= BOARD_MOVES ? shift : 0, light = step >= LIGHT_MOVES ? -shift / 2 : 0;
    Scene scene = closed_wall(6, 10, 2 * atanf(0.25f));
    scene.camera.eye.x = scene.camera.target.x = step >= CAMERA_MOVES ? 0.5f : 0;
    if (sheet)
        closed_stand(&scene, vec3_make(board, 0, 12), half_board, half_board, 0);
    else
        closed_add(&scene, SHAPE_BOX, vec3_make(board, 0, 12), vec3_make(half_board, half_board, 0.01f), 0);
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(light, 0, 20), vec3_make(light, 0, 0), 0, 4, 1, 30);
    return scene;
}

// Draws the scene by the lab as it is and by its change: the area that they show otherwise, in boards.
static bool differ(LabSet *labs, Findings *findings, int slot, const Scene *scene, const Change *change,
                   double *boards) {
    static float own[SIDE * SIDE];
    Probe probe;
    bool ok = probe_begin(&probe, labs, LAB_ID, scene, SIDE, SIDE);
    probe_knob(&probe, "method", LINEAR);
    probe_knob(&probe, "map size", MAP);
    ok = ok && probe_draw(&probe);
    if (ok)
        memcpy(own, probe.measured.visibility, sizeof own);
    probe.change = change;
    ok = ok && probe_draw(&probe);
    *boards = 0;
    for (int i = 0; ok && i < SIDE * SIDE; i++)
        *boards += fabs((double)(probe.measured.visibility[i] - own[i])) * probe_unit(&probe) *
                   probe_unit(&probe) / (4 * half_board * half_board);
    if (ok)
        findings_frame(findings, slot, *boards, &probe.truth_view, &probe.measured,
                       "%s: %.2f boards otherwise", change->name, *boards);
    probe_end(&probe);
    return ok;
}

// The tolerance of an area of boards: half a pixel along each edge.
static double tolerance(int boards) {
    const Scene scene = at_step(0, false);
    return boards * 4 * closed_unit(&scene, SIDE) / 2 / (2 * half_board);
}

// One point of a curve: what the lab and its change show otherwise at this step, in boards.
static bool add_point(LabSet *labs, Findings *findings, int slot, Curve *curve, int step, bool sheet,
                      const Change *change, int expected) {
    const Scene scene = at_step(step, sheet);
    double boards;
    if (!differ(labs, findings, slot, &scene, change, &boards))
        return false;
    curve_add(curve, step, boards, expected, tolerance(expected));
    return true;
}

// A map that is kept though the board has moved shows its shadow where it was: two boards are wrong. When the
// light moves, the map moves with it, and the shadow in it comes along.
static bool run_kept(LabSet *labs, Findings *findings) {
    static const int wrong[STEPS] = {0, 0, 2, 2, 2};
    Figure *figure = findings_figure(findings, "A map that is kept",
                                     "step: a camera, a board and a light move", "shown otherwise (boards)");
    Curve *kept = figure_curve(figure, "kept while nothing moves", CURVE_EQUAL),
          *always = figure_curve(figure, "failure: kept whatever moves", CURVE_EQUAL);
    bool ok = true;
    for (int step = 0; ok && step < STEPS; step++)
        ok = add_point(labs, findings, 0, kept, step, false, &filter_kept, 0) &&
             add_point(labs, findings, 1, always, step, false, &always_kept, wrong[step]);
    return ok;
}

// What only receives is no caster: leaving it out changes nothing, as long as nothing lies behind it.
static bool run_casters(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "A map of what casts alone",
                                     "step: a camera, a board and a light move", "shown otherwise (boards)");
    Curve *boxes = figure_curve(figure, "planes receive, boxes cast", CURVE_EQUAL),
          *sheets = figure_curve(figure, "failure: a plane that casts", CURVE_EQUAL);
    bool ok = true;
    for (int step = 0; ok && step < STEPS; step++)
        ok = add_point(labs, findings, 2, boxes, step, false, &filter_casters, 0) &&
             add_point(labs, findings, 2, sheets, step, true, &filter_casters, 1);
    return ok;
}

static bool run_faster(LabSet *labs, Findings *findings) {
    return run_kept(labs, findings) && run_casters(labs, findings);
}

const Row LAB_TABLE[] = {
    {100 * LAB_NUMBER + 1, "maps drawn less", "a map that is kept, and a map of the casters",
     "a camera moves, a board moves, a light moves, nothing moves",
     "A map that is kept shows the same as one that is drawn for each frame, if it is drawn again when the "
     "light or an object has moved; kept whatever moves, it shows the shadow where it was: two boards are "
     "wrong. Without the planes a map shows the same, too, unless one of them casts: its shadow is missing.",
     "closed form", run_faster},
    {0},
};
