// Shadow maps in motion: what flickers when the map's grid moves over a shadow that stands still.
#include "scene/check.h"
#include "truth/closed_scenes.h"
#include "stability/probe.h"
#include "stability/row.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// A texel is 1/16 of a world unit wide and 8 pixels of the picture, which is 112 texels long. The shadow's
// edge rises by a texel in 16, so that all phases between edge and grid occur equally often; none lies on the
// middle of a texel.
enum { TEXEL = 8, COLUMNS = 112, WIDTH = COLUMNS * TEXEL, HEIGHT = 128, RISE = 16, MAP = 128 };
static const double texel = 1.0 / 16, length = 7;

// The map moves up by `shift` with its light. The board is out of sight behind the camera.
static Scene edge_scene(double shift) {
    Scene scene = closed_wall(6, 10, 2 * atanf(0.05f));
    const float turn = atanf(1.0f / RISE);
    closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, 12), vec3_make(1, 1, 1), 0);
    mat4s placed = glms_rotate(scene.objects[1].world_from_object, turn, vec3_make(0, 0, 1));
    scene.objects[1].world_from_object =
        glms_scale(glms_translate(placed, vec3_make(0, -3, 0)), vec3_make(6, 3, 0.1f));
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(0, (float)shift, 20), vec3_make(0, (float)shift, 0), 0,
                 (float)(MAP * texel / 2), 1, 30);
    return scene;
}

// Draws into `visibility`.
static bool draw(LabSet *labs, Findings *findings, double shift, double flips, float *visibility) {
    const Scene scene = edge_scene(shift);
    Probe probe;
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, WIDTH, HEIGHT);
    probe_knob(&probe, "map size", MAP);
    ok = ok && probe_draw(&probe);
    if (ok) {
        memcpy(visibility, probe.measured.visibility, sizeof(float) * WIDTH * HEIGHT);
        findings_frame(findings, 0, flips, &probe.truth_view, &probe.measured,
                       "An edge with the map's grid moved by %g texels", shift / texel);
    }
    probe_end(&probe);
    return ok;
}

// What changed, per length of the edge: world units.
static double flipped(const float *before, const float *after) {
    double pixels = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        pixels += fabsf(before[i] - after[i]);
    return pixels * (length / WIDTH) * (length / WIDTH) / length;
}

// `step`: of the light, texels. `snapped`: it moves by whole texels only. One column of texels may be off by
// a texel.
static bool sweep(LabSet *labs, Findings *findings, Curve *curve, float *visibility, double step,
                  bool snapped) {
    float *still = visibility, *moving = visibility + WIDTH * HEIGHT;
    bool ok = draw(labs, findings, 0, 0, still);
    for (int i = 0; ok && i <= TEXEL; i++) {
        double d = step * i, flips = snapped ? 0 : 2 * d * (1 - d);
        ok = draw(labs, findings, (snapped ? round(d) : d) * texel, flips, moving);
        if (ok)
            curve_add(curve, d, flipped(still, moving) / texel, flips, 1.0 / COLUMNS);
    }
    return ok;
}

static bool run_motion(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "The map's grid moves", "shift of the light (texels)",
                                     "flipped area per length of the edge (texels)");
    Curve *moved = figure_curve(figure, "failure: any shift", CURVE_EQUAL),
          *snapped = figure_curve(figure, "remedy: whole texels", CURVE_EQUAL);
    float *visibility = calloc(2 * WIDTH * HEIGHT, sizeof *visibility);
    bool ok = (visibility || check_fail("out of memory for two frames")) &&
              sweep(labs, findings, moved, visibility, 1.0 / TEXEL, false) &&
              sweep(labs, findings, snapped, visibility, 0.7, true);
    free(visibility);
    return ok;
}

const Row LAB_TABLE[] = {
    {18, "motion", "shadow map",
     "the light moves along the map, by 0 to 1 texels, and by 0 to 5.6 in whole texels",
     "A shadow's edge follows the map's texels. When the grid moves by d under an edge that stands still, "
     "the "
     "edge moves by d or jumps back by s - d, s being the texel: 2 d (1 - d / s) on average. Where the light "
     "moves by whole texels only, nothing changes.",
     "closed form", run_motion},
    {0},
};
