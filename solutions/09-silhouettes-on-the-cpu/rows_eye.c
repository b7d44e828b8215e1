// Counting from the eye: z-pass with the number of volumes around it, volumes that end, and places far away.
#include "scene/count.h"
#include "stability/probe.h"
#include "stability/row.h"
#include "stability/sight.h"
#include "truth/closed_scenes.h"

#include <math.h>
#include <string.h>

enum { SIDE = 160, FROM_ZERO = 0, FROM_EYE, Z_FAIL };

static const Change unclamped = {
    .name = "no depth clamp", .edits = {{"lab.c", "glEnable(GL_DEPTH_CLAMP);", ""}}, .edit_count = 1};
static const Change from_the_world = {
    .name = "places in the world",
    .edits = {{"stages.h", "const vec3s eye = scene->camera.eye;", "const vec3s eye = vec3_make(0, 0, 0);"},
              {"stages.h", "    scene->camera.eye = vec3_make(0, 0, 0);\n", ""}},
    .edit_count = 2};

// A way of counting, and its curve.
typedef struct Counting {
    LabSet *labs;
    Findings *findings;
    Curve *curve;
    int slot, method;
    const Change *change;
} Counting;

static bool begin(Probe *probe, const Counting *counting, const Scene *scene) {
    bool ok = probe_begin(probe, counting->labs, LAB_ID, scene, SIDE, SIDE);
    probe->change = counting->change;
    probe_knob(probe, "method", counting->method);
    return ok && probe_draw(probe);
}

static void keep_frame(const Counting *counting, const Probe *probe, double x) {
    findings_frame(counting->findings, counting->slot, probe->measured.metrics.all.mae, &probe->truth_view,
                   &probe->measured, "%s, at %g in the figure", counting->curve->name, x);
}

// Where the way of counting `fails`, just those pixels are wrong whose point on the near plane is in a
// shadow.
static bool add_point(const Counting *counting, const Scene *scene, double x, bool fails) {
    Probe probe;
    SightShare share = {0};
    bool ok = begin(&probe, counting, scene);
    if (ok && fails)
        ok = sight_share_at(&probe, scene->camera.near_plane, &share);
    if (ok) {
        share = fails ? share : sight_share(&probe, NULL);
        curve_add(counting->curve, x, probe.measured.metrics.all.mae, share.share, share.tolerance);
        keep_frame(counting, &probe, x);
    }
    probe_end(&probe);
    return ok;
}

static bool sweep_eye(const Counting *counting) {
    bool ok = true;
    for (int i = 0; ok && i <= 16; i++) {
        float x = -1.6f + 0.2f * (float)i;
        Scene scene =
            closed_wall_and_box(vec3_make(0, 0, 10), vec3_make(0, 0, 5), vec3_make(0.5f, 0.5f, 0.1f));
        scene.camera.eye = vec3_make(x, 0, 4);
        scene.camera.target = vec3_make(x, 0, 0);
        scene.camera.near_plane = 0.05f;
        ok = add_point(counting, &scene, x, counting->method == FROM_ZERO);
    }
    return ok;
}

// The eye is outside of the shadow.
static bool sweep_near(const Counting *counting) {
    bool ok = true;
    for (int i = 0; ok && i <= 16; i++) {
        Scene scene =
            closed_wall_and_box(vec3_make(10, 0, 3), vec3_make(3, 0, 5), vec3_make(0.3f, 0.5f, 0.3f));
        scene.camera.near_plane = 0.5f + 0.5f * (float)i;
        ok = add_point(counting, &scene, scene.camera.near_plane, counting->change != NULL);
    }
    return ok;
}

static bool run_eye(LabSet *labs, Findings *findings) {
    Figure *eye = findings_figure(findings, "The eye goes through a shadow, from -0.5 to 0.5",
                                  "place of the eye (world units)", "wrong pixels (share)"),
           *near = findings_figure(findings, "The near plane goes through a shadow before the wall",
                                   "distance of the near plane (world units)", "wrong pixels (share)");
    const Counting by_eye[] = {
        {labs, findings, figure_curve(eye, "failure: z-pass from 0", CURVE_EQUAL), 0, FROM_ZERO, NULL},
        {labs, findings, figure_curve(eye, "remedy: z-pass from the number around the eye", CURVE_EQUAL), 1,
         FROM_EYE, NULL},
        {labs, findings, figure_curve(eye, "remedy: z-fail", CURVE_EQUAL), 1, Z_FAIL, NULL}};
    const Counting by_near[] = {
        {labs, findings, figure_curve(near, "failure: faces before the near plane are cut off", CURVE_EQUAL),
         2, FROM_EYE, &unclamped},
        {labs, findings, figure_curve(near, "remedy: depth clamp", CURVE_EQUAL), 1, FROM_EYE, NULL}};
    bool ok = true;
    for (size_t i = 0; ok && i < COUNT(by_eye); i++)
        ok = sweep_eye(&by_eye[i]);
    for (size_t i = 0; ok && i < COUNT(by_near); i++)
        ok = sweep_near(&by_near[i]);
    return ok;
}

// A thin board at the height h over the wall, under a lamp at H: behind it the wall is h / (H - h) times as
// far as the board is from the lamp. A volume that ends before leaves the wall lit.
static bool sweep_stretch(LabSet *labs, Findings *findings, Curve *curve, float height) {
    const float lamp = 6, needed = height / (lamp - height);
    bool ok = true;
    for (int i = 0; ok && i <= 8; i++) {
        float stretch = i == 8 ? 0 : needed * (0.6f + 0.1f * (float)(i + (i >= 4)));
        Scene scene = closed_wall(6, 10, glm_rad(40));
        closed_add(&scene, SHAPE_BOX, vec3_make(-0.6f, 0.2f, height), vec3_make(0.3f, 0.3f, 1e-4f), 0);
        closed_light(&scene, LIGHT_POINT, vec3_make(-2, 0.5f, lamp), vec3_make(0, 0, 0), 1, 0, 1, 20);
        const Counting counting = {labs, findings, curve, 0, FROM_EYE, NULL};
        Probe probe;
        ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE);
        probe_knob(&probe, "method", FROM_EYE);
        probe_knob(&probe, "stretch", stretch);
        ok = ok && probe_draw(&probe);
        if (ok) {
            double x = stretch / needed;
            curve_add(curve, i == 8 ? 2 : x, probe_false(&probe, 0, 1), i < 8 && x < 1 ? 1 : 0, 0);
            keep_frame(&counting, &probe, x);
        }
        probe_end(&probe);
    }
    return ok;
}

static bool run_stretch(LabSet *labs, Findings *findings) {
    Figure *figure =
        findings_figure(findings, "Volumes that end (at 2: without an end)",
                        "stretch (of the one that is needed)", "false light (share of the shadow)");
    return sweep_stretch(labs, findings, figure_curve(figure, "a board near the wall", CURVE_EQUAL), 1) &&
           sweep_stretch(labs, findings, figure_curve(figure, "a board in the middle", CURVE_EQUAL), 3) &&
           sweep_stretch(labs, findings, figure_curve(figure, "a board near the lamp", CURVE_EQUAL), 4);
}

static void move(Scene *scene, float far) {
    const vec3s by = vec3_make(far, 0, far);
    for (int i = 0; i < scene->object_count; i++)
        for (int k = 0; k < 3; k++)
            scene->objects[i].world_from_object.raw[3][k] += by.raw[k];
    vec3s *const places[] = {&scene->lights[0].position, &scene->lights[0].target, &scene->camera.eye,
                             &scene->camera.target};
    for (size_t i = 0; i < COUNT(places); i++)
        *places[i] = glms_vec3_add(*places[i], by);
}

// All places are multiples of 1/64, so that they stay the same to the last bit when they are moved by a whole
// number up to 2^17. The eye stands in the shadow of an arch.
static Scene far_scene(void) {
    Scene scene = closed_wall(6, 10, glm_rad(40));
    closed_add(&scene, SHAPE_SPHERE, vec3_make(0.625f, -0.5f, 1.5f), vec3_make(0.5f, 0.5f, 0.5f), 0);
    closed_add(&scene, SHAPE_ARCH, vec3_make(0.25f, -0.25f, 12), vec3_make(0.3f, 1, 0.3f), 90);
    closed_light(&scene, LIGHT_POINT, vec3_make(0.5f, 0, 14), vec3_make(0, 0, 0), glm_rad(70), 0, 2, 12);
    return scene;
}

// In truth. With the eye in a shadow, z-pass from 0 is wrong in all these pixels: each counts one too few.
static double lit_share(const Probe *probe) {
    double lit = 0, count = 0;
    for (int i = 0; i < SIDE * SIDE; i++)
        if (probe->measured.mask[i]) {
            lit += (double)probe->truth_view.visibility[i];
            count++;
        }
    return count > 0 ? lit / count : 0;
}

// `home` gets what is wrong at the origin; NULL: not there.
static bool draw_far(const Counting *counting, float far, Image *image, Curve *home) {
    static Reply reply;
    Scene scene = far_scene();
    move(&scene, far);
    Probe probe;
    bool ok = begin(&probe, counting, &scene);
    LabArtist *artist = ok ? lab_set_artist(counting->labs, LAB_ID, counting->change) : NULL;
    if (artist) {
        const Request request = truth_view_request(&probe.truth_view, &probe.setting);
        ok = lab_artist_draw(artist, &request, image, &reply);
        keep_frame(counting, &probe, (double)far);
        const SightShare none = sight_share(&probe, NULL);
        if (home)
            curve_add(home, counting->method, probe.measured.metrics.all.mae,
                      counting->method == FROM_ZERO ? lit_share(&probe) : 0, none.tolerance);
    }
    probe_end(&probe);
    return ok && artist;
}

static bool sweep_far(const Counting *counting, Curve *at_home) {
    Image home = {0};
    bool ok = draw_far(counting, 0, &home, at_home);
    for (int power = 1; ok && power <= 17; power += 2) {
        const float far = ldexpf(1, power);
        Image away = {0};
        ok = draw_far(counting, far, &away, NULL);
        int different = 0;
        for (int i = 0; ok && i < SIDE * SIDE; i++)
            different += memcmp(home.rgba + 4 * (size_t)i, away.rgba + 4 * (size_t)i, 4) != 0;
        if (counting->curve->rule == CURVE_EQUAL)
            curve_add(counting->curve, (double)far, different, 0, 0);
        else if (power >= 15)
            curve_add(counting->curve, (double)far, different, 1, 0);
        image_destroy(&away);
    }
    image_destroy(&home);
    return ok;
}

static bool run_far(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "Away from the origin", "distance along x and z (world units)",
                                     "pixels that differ from those at the origin"),
           *origin =
               findings_figure(findings, "At the origin", "0: count from 0, 1: count from the eye, 2: z-fail",
                               "wrong pixels (share)");
    figure->log_x = true;
    Curve *world = figure_curve(figure, "failure: places in the world, z-fail", CURVE_LEAST),
          *eye = figure_curve(figure, "remedy: places from the eye, z-fail", CURVE_EQUAL),
          *number = figure_curve(figure, "remedy: places and count from the eye", CURVE_EQUAL),
          *home = figure_curve(origin, "places from the eye", CURVE_EQUAL),
          *zero = figure_curve(origin, "failure: z-pass from 0, the eye in the arch's shadow", CURVE_LEAST);
    Image image = {0};
    const bool counts = draw_far(&(Counting){labs, findings, zero, 2, FROM_ZERO, NULL}, 0, &image, zero);
    image_destroy(&image);
    if (!counts)
        return false;
    return sweep_far(&(Counting){labs, findings, world, 0, Z_FAIL, &from_the_world}, NULL) &&
           sweep_far(&(Counting){labs, findings, eye, 1, Z_FAIL, NULL}, home) &&
           sweep_far(&(Counting){labs, findings, number, 1, FROM_EYE, NULL}, home);
}

const Row LAB_TABLE[] = {
    {901, "z-pass with a number", "volumes made on the CPU", "the eye and the near plane go through a shadow",
     "Z-pass from 0 is wrong in all pixels whose point on the near plane is in a shadow. From the number of "
     "volumes "
     "around the eye it is right wherever the eye stands, as long as nothing lies between the eye and the "
     "near plane. "
     "With clamped depths nothing is cut off there, and it is right everywhere.",
     "closed form: rays from the near plane to the light", run_eye},
    {902, "volumes that end", "volumes made on the CPU", "the stretch, around the one that is needed",
     "A board at h under a lamp at H over a wall needs a stretch of h / (H - h): with less the wall is lit, "
     "with more it "
     "has its shadow. A low lamp needs any stretch; a volume without an end needs none.",
     "closed form: similar triangles", run_stretch},
    {903, "far from the origin, from the eye", "volumes made on the CPU",
     "the whole scene, up to 131,072 away from the world's origin",
     "Places that are multiples of 1/64 lose nothing when they are moved by 2^n, and the difference of two "
     "of them is "
     "exact. So what is measured from the eye is the same to the last bit, and so are the pictures. In "
     "places of the "
     "world each corner rounds to its own step. At the origin no pixel is wrong, and all "
     "that is lit is where z-pass begins at 0.",
     "IEEE 754, single precision: differences of near numbers are exact", run_far},
    {0},
};
