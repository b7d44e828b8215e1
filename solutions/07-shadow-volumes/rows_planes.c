// Shadow volumes and what cuts them: the eye, the near plane, the far plane and the end of the depth buffer.
#include "rows_counting.h"
#include "truth/closed_scenes.h"
#include "scene/count.h"

enum { SIZE = COUNTING_SIZE };

// Surfaces and volumes end at the camera's far plane, as they do before task 7.8.
static const Change finite_far_plane = {
    .name = "a finite far plane",
    .edits =
        {{"lab.c",
          "    clip_from_view.raw[2][2] = -1;\n    clip_from_view.raw[3][2] = -2 * camera->near_plane;\n",
          ""}},
    .edit_count = 1};

// Where the method `fails`, wrong pixels must be those whose ray's point at `depth` is in a volume; else
// none.
static bool add_point(const Counting *method, const Scene *scene, double x, double depth, bool fails) {
    Probe probe;
    SightShare share;
    bool ok = counting_begin(&probe, method, scene) && sight_share_at(&probe, depth, &share);
    if (ok)
        counting_add(method, &probe, x, fails ? share : sight_share(&probe, NULL), share.share);
    probe_end(&probe);
    return ok;
}

static bool sweep_eye(const Counting *method) {
    bool ok = true;
    for (int i = 0; ok && i <= 16; i++) {
        float x = -1.6f + 0.2f * (float)i;
        Scene scene =
            closed_wall_and_box(vec3_make(0, 0, 10), vec3_make(0, 0, 5), vec3_make(0.5f, 0.5f, 0.1f));
        scene.camera.eye = vec3_make(x, 0, 4);
        scene.camera.target = vec3_make(x, 0, 0);
        scene.camera.near_plane = 0.05f;
        ok = add_point(method, &scene, x, scene.camera.near_plane, method->method == Z_PASS);
    }
    return ok;
}

static bool run_eye(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "The eye goes through a shadow, from -0.5 to 0.5",
                                     "place of the eye (world units)", "wrong pixels (share)");
    return sweep_eye(&(Counting){labs, findings, figure_curve(figure, "failure: z-pass", CURVE_EQUAL), NULL,
                                 Z_PASS, 0}) &&
           sweep_eye(&(Counting){labs, findings, figure_curve(figure, "remedy: z-fail", CURVE_EQUAL), NULL,
                                 Z_FAIL, 1});
}

static bool sweep_near(const Counting *method) {
    bool ok = true;
    for (int i = 0; ok && i <= 16; i++) {
        Scene scene =
            closed_wall_and_box(vec3_make(10, 0, 3), vec3_make(3, 0, 5), vec3_make(0.3f, 0.5f, 0.3f));
        scene.camera.near_plane = 0.5f + 0.5f * (float)i;
        ok = add_point(method, &scene, scene.camera.near_plane, scene.camera.near_plane,
                       method->method == Z_PASS);
    }
    return ok;
}

static bool run_near(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "The near plane goes through a shadow before the wall",
                                     "distance of the near plane (world units)", "wrong pixels (share)");
    return sweep_near(&(Counting){labs, findings, figure_curve(figure, "failure: z-pass", CURVE_EQUAL), NULL,
                                  Z_PASS, 0}) &&
           sweep_near(&(Counting){labs, findings, figure_curve(figure, "remedy: z-fail", CURVE_EQUAL), NULL,
                                  Z_FAIL, 1});
}

// The wall is 10 units away.
static bool sweep_far(const Counting *method, bool cut) {
    const float behind[] = {0.1f, 0.25f, 0.5f, 1, 1.5f, 2, 3, 4, 6, 8};
    bool ok = true;
    for (size_t i = 0; ok && i < COUNT(behind); i++) {
        Scene scene =
            closed_wall_and_box(vec3_make(10, 0, 10), vec3_make(2, 0, 2), vec3_make(0.5f, 0.8f, 0.5f));
        scene.camera.far_plane = 10 + behind[i];
        ok = add_point(method, &scene, behind[i], scene.camera.far_plane, cut);
    }
    return ok;
}

static bool run_far(LabSet *labs, Findings *findings) {
    Figure *figure =
        findings_figure(findings, "Z-fail with the far plane behind the wall",
                        "distance of the far plane from the wall (world units)", "wrong pixels (share)");
    figure->log_x = true;
    Curve *finite = figure_curve(figure, "failure: finite far plane", CURVE_EQUAL),
          *infinite = figure_curve(figure, "remedy: infinite projection", CURVE_EQUAL),
          *clamped = figure_curve(figure, "remedy: GL_DEPTH_CLAMP", CURVE_EQUAL);
    LabArtist *artist = lab_set_artist(labs, LAB_ID, NULL);
    const Change *clamp =
        artist ? rubric_alternative(&artist->rubric, "a finite far plane with GL_DEPTH_CLAMP") : NULL;
    return clamp && sweep_far(&(Counting){labs, findings, finite, &finite_far_plane, Z_FAIL, 0}, true) &&
           sweep_far(&(Counting){labs, findings, infinite, NULL, Z_FAIL, 1}, false) &&
           sweep_far(&(Counting){labs, findings, clamped, clamp, Z_FAIL, 2}, false);
}

// Looks at the sky alone, where no shadow can fall: all counts must be 0.
static void mask_sky(Probe *probe) {
    for (int i = 0; i < SIZE * SIZE; i++)
        probe->measured.mask[i] = probe->truth_view.picture.hits[i].object == TRUTH_NONE &&
                                  probe->truth_view.drawn[i] == METRICS_NO_PRIMITIVE;
}

static double counted_sky(const Probe *probe) {
    double sky = 0, counted = 0;
    for (int i = 0; i < SIZE * SIZE; i++)
        if (probe->measured.mask[i]) {
            sky++;
            counted += probe->measured.visibility[i] > 0;
        }
    return counted / sky;
}

// A lamp before a square plate before an open sky: the plate's far cap lies in the middle of the picture,
// around the plate.
static bool sweep_sky(const Counting *method, bool capped) {
    bool ok = true;
    for (int i = 1; ok && i <= 10; i++) {
        float side = 0.06f * (float)i;
        Scene scene = closed_wall(6, 10, glm_rad(40));
        scene.object_count = 0;
        closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, 2), vec3_make(side, side, 0.05f), 0);
        closed_light(&scene, LIGHT_SPOT, vec3_make(0.1f, 0, 4), vec3_make(0, 0, 0), glm_rad(90), 0, 1, 20);
        Probe probe;
        SightShare share = {0};
        ok = probe_begin(&probe, method->labs, LAB_ID, &scene, SIZE, SIZE);
        probe.change = method->change;
        probe.setting.view = "stencil counts";
        probe_knob(&probe, "method", Z_FAIL);
        ok = ok && probe_draw(&probe);
        if (ok) {
            mask_sky(&probe);
            ok = sight_share_at(&probe, INFINITY, &share);
            curve_add(method->curve, 2 * side, counted_sky(&probe), capped ? share.share : 0,
                      capped ? share.tolerance : 0);
            findings_frame(method->findings, method->slot, side, &probe.truth_view, &probe.measured,
                           "Counts with a plate %g wide: %s", 2 * side, method->curve->name);
        }
        probe_end(&probe);
    }
    return ok;
}

static bool run_sky(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "Z-fail before an open sky",
                                     "width of the plate (world units)", "sky with a count (share)");
    Curve *less = figure_curve(figure, "failure: GL_LESS", CURVE_EQUAL),
          *equal = figure_curve(figure, "remedy: GL_LEQUAL", CURVE_EQUAL);
    LabArtist *artist = lab_set_artist(labs, LAB_ID, NULL);
    const Change *mistake =
        artist ? rubric_mistake(&artist->rubric, "z-fail keeps the depth function GL_LESS") : NULL;
    return mistake && sweep_sky(&(Counting){labs, findings, less, mistake, Z_FAIL, 0}, true) &&
           sweep_sky(&(Counting){labs, findings, equal, NULL, Z_FAIL, 1}, false);
}

#define SIGHT "closed form: rays against the caster from each pixel's point on the plane"

const Row LAB_TABLE[] = {
    {19, "eye in a shadow", "z-pass, z-fail", "the eye moves through a shadow volume",
     "Z-pass counts from the eye: when the eye stands in a volume, each count is one too small, and light "
     "and "
     "shadow change places. Z-fail counts from infinity and does not care.",
     SIGHT, run_eye},
    {20, "near plane in a shadow", "z-pass, z-fail",
     "the near plane moves through a shadow volume that lies before the wall",
     "Z-pass loses the front faces that the near plane cuts away, and the back faces behind them make a "
     "false "
     "shadow: just where the plane's point is in the volume, so only while the plane crosses it. Z-fail is "
     "right everywhere.",
     SIGHT, run_near},
    {21, "far plane", "z-fail", "the far plane moves away behind the wall",
     "With a finite far plane the volumes are cut off behind the wall, and z-fail is wrong where the plane's "
     "point is in a volume. A projection without a far plane, or GL_DEPTH_CLAMP, fixes it at any distance.",
     SIGHT, run_far},
    {22, "open sky", "z-fail", "the width of a plate between a lamp and the sky",
     "A far cap at infinity has depth 1, and so has the empty sky. GL_LESS lets the cap fail there, and "
     "z-fail counts it: the sky stands in a shadow. GL_LEQUAL counts nothing.",
     "closed form: rays from the lamp against the plate in each pixel's direction", run_sky},
    {0},
};
