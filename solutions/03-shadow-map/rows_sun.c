// A sun straight above a camera that looks straight down, and a sun that turns.
#include "scene/check.h"
#include "scene/count.h"
#include "truth/closed_scenes.h"
#include "stability/probe.h"
#include "stability/row.h"

#include <stdlib.h>
#include <string.h>

enum { SIDE = 160 };

// A board high above the camera, which sees 4 x 4 units of the floor below it. The sun comes from the north,
// `tilt` degrees from straight above.
static const double board = 0.5, height = 6, seen = 4;

static Scene overhead(double tilt, double azimuth) {
    const double t = closed_radians(tilt), a = closed_radians(azimuth), away = 12;
    Scene scene = {.camera = {.eye = vec3_make(0, 4, 0),
                              .fov_y = (float)(2 * atan(seen / 2 / 4)),
                              .near_plane = 0.5f,
                              .far_plane = 8}};
    closed_add(&scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(4, 1, 4), 0);
    closed_add(&scene, SHAPE_BOX, vec3_make(0, (float)height, 0),
               vec3_make((float)board, 0.0005f, (float)board), 0);
    closed_light(
        &scene, LIGHT_DIRECTIONAL,
        vec3_make((float)(away * sin(t) * sin(a)), (float)(away * cos(t)), (float)(away * sin(t) * cos(a))),
        vec3_make(0, 0, 0), 0, 4, 1, 24);
    return scene;
}

// The dark share of all pixels, and how far the dark ones lie from the middle, world units.
static void measure_shadow(const Probe *probe, double *share, double *away) {
    double dark = 0, x = 0, z = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        const double here = 1 - (double)probe->measured.visibility[i];
        dark += here;
        x += here * (double)probe->truth_view.picture.hits[i].position.x;
        z += here * (double)probe->truth_view.picture.hits[i].position.z;
    }
    *share = dark / (SIDE * SIDE);
    *away = dark > 0 ? hypot(x, z) / dark : INFINITY;
}

static const double tilts[] = {0, 1e-4, 1e-3, 0.01, 0.05, 0.0573, 0.06, 0.1, 1, 4, 8};

static bool sweep_overhead(LabSet *labs, Findings *findings, Curve *share, Curve *away, const char *lab) {
    enum { MAP = 512 };
    const double step = 8.0 / MAP / 2 + seen / SIDE / 2; // half a texel and half a pixel
    bool ok = true;
    for (unsigned i = 0; ok && i < COUNT(tilts); i++) {
        const Scene scene = overhead(tilts[i], 36.0 * i);
        double dark, place;
        Probe probe;
        ok = probe_begin(&probe, labs, lab, &scene, SIDE, SIDE);
        if (ok && strcmp(lab, "07") != 0)
            probe_knob(&probe, "map size", MAP);
        ok = ok && probe_draw(&probe);
        if (ok) {
            measure_shadow(&probe, &dark, &place);
            curve_add(share, tilts[i], dark, 4 * board * board / (seen * seen),
                      8 * board * step / (seen * seen));
            curve_add(away, tilts[i], place, height * tan(closed_radians(tilts[i])), step);
            findings_frame(findings, 0, fabs(dark - 4 * board * board / (seen * seen)), &probe.truth_view,
                           &probe.measured, "Lab %s, the sun %g degrees from straight above", lab, tilts[i]);
        }
        probe_end(&probe);
    }
    return ok;
}

static bool run_overhead(LabSet *labs, Findings *findings) {
    static const char *const names[] = {"lab 03", "lab 05", "lab 07"}, *const ids[] = {"03", "05", "07"};
    static const char sun[] = "the sun's angle from straight above (degrees)";
    Figure *share = findings_figure(findings, "A square shadow, seen from straight above", sun,
                                    "dark share of the picture"),
           *away = findings_figure(findings, "How far it lies from below the board", sun,
                                   "distance (world units)");
    bool ok = true;
    for (unsigned i = 0; ok && i < COUNT(ids); i++)
        ok = sweep_overhead(labs, findings, figure_curve(share, names[i], CURVE_EQUAL),
                            figure_curve(away, names[i], CURVE_EQUAL), ids[i]);
    return ok;
}

// A ball just above a wall, far from the middle of the map, under a sun that turns about the wall's normal.
enum { MAP = 1024, FRAMES = 24, PICTURE = 400 };
static const double slant = 50, radius = 0.25, half_map = 8, wall_seen = 1.5, reach = 6;

static Scene turning(double azimuth) {
    const double t = closed_radians(slant), a = closed_radians(azimuth), away = 12;
    Scene scene = closed_wall(9, 10, (float)(2 * atan(wall_seen / 2 / 10)));
    scene.camera.eye = vec3_make((float)reach, 0, 10);
    scene.camera.target = vec3_make((float)reach, 0, 0);
    closed_add(&scene, SHAPE_SPHERE, vec3_make((float)reach, 0, (float)radius),
               vec3_make((float)radius, (float)radius, (float)radius), 0);
    closed_light(
        &scene, LIGHT_DIRECTIONAL,
        vec3_make((float)(away * sin(t) * cos(a)), (float)(away * sin(t) * sin(a)), (float)(away * cos(t))),
        vec3_make(0, 0, 0), 0, (float)half_map, 1, 24);
    return scene;
}

// How much of the shadow's edge is seen beside the ball: of points all around the ball, across the light,
// each is followed to the wall.
static double seen_edge(const Probe *probe) {
    enum { POINTS = 720 };
    const Light *light = &probe->truth_view.truth.scene.lights[0];
    const vec3s from = glms_vec3_normalize(light->position);
    const vec3s u = glms_vec3_normalize(glms_vec3_cross(from, vec3_make(0, 0, 1))),
                v = glms_vec3_cross(from, u);
    int found = 0;
    for (int i = 0; i < POINTS; i++) {
        const float a = (float)i * 2 * GLM_PIf / POINTS;
        const vec3s around = glms_vec3_scale(
            glms_vec3_add(glms_vec3_scale(u, cosf(a)), glms_vec3_scale(v, sinf(a))), (float)radius);
        const vec3s ball =
            glms_vec3_add(around, vec3_make(0, 0, (float)radius)); // from the middle of the picture
        const vec3s wall = glms_vec3_sub(ball, glms_vec3_scale(from, ball.z / from.z));
        const int column = (int)floor(PICTURE * (0.5 + (double)wall.x / wall_seen)),
                  row = (int)floor(PICTURE * (0.5 - (double)wall.y / wall_seen));
        const bool inside = column >= 0 && column < PICTURE && row >= 0 && row < PICTURE;
        const int pixel = row * PICTURE + column;
        found += inside && probe->measured.mask[pixel] && probe->truth_view.picture.hits[pixel].object == 0;
    }
    return (double)found / POINTS;
}

// Draws one frame; `wrong` gets what differs from the truth, 1 (false light) or -1 a pixel, and `edge` how
// much of the edge is seen.
static bool draw_turned(LabSet *labs, Findings *findings, const char *lab, double azimuth, float *lit,
                        float *truth, double *edge) {
    const Scene scene = turning(azimuth);
    Probe probe;
    bool ok = probe_begin(&probe, labs, lab, &scene, PICTURE, PICTURE);
    if (ok && strcmp(lab, "07") != 0)
        probe_knob(&probe, "map size", MAP);
    ok = ok && probe_draw(&probe);
    for (int i = 0; ok && i < PICTURE * PICTURE; i++) {
        const bool counts = probe.measured.mask[i] && probe.truth_view.picture.hits[i].object == 0;
        lit[i] = counts ? probe.measured.visibility[i] : 0;
        truth[i] = counts ? probe.truth_view.visibility[i] : 0;
    }
    *edge += ok ? seen_edge(&probe) : 0;
    if (ok)
        findings_frame(findings, 0, probe.measured.metrics.all.mae, &probe.truth_view, &probe.measured,
                       "Lab %s, the sun at %.2f degrees", lab, azimuth);
    probe_end(&probe);
    return ok;
}

static double flips(const float *a, const float *b) {
    double pixels = 0;
    for (int i = 0; i < PICTURE * PICTURE; i++)
        pixels += fabs((double)a[i] - (double)b[i]);
    return pixels;
}

// What flips from frame to frame, of the lab and of the truth, per length of the edge in the map: texels.
typedef struct Flicker {
    double lab, truth;
} Flicker;

// From the azimuth `first` on, by 1 to 5 texels a frame, so that all fractions of a texel occur alike.
static bool flicker(LabSet *labs, Findings *findings, const char *lab, double first, Flicker *flicker) {
    enum { PIXELS = PICTURE * PICTURE };
    const double unit = wall_seen / PICTURE, texel = 2 * half_map / MAP;
    float *frames = calloc(4 * PIXELS, sizeof *frames);
    double edge = 0, turned = 0; // texels
    bool ok = true;
    INVARIANT(frames);
    *flicker = (Flicker){0};
    for (int n = 0; ok && n <= FRAMES; n++) {
        float *now = frames + (n % 2) * 2 * PIXELS, *before = frames + (1 - n % 2) * 2 * PIXELS;
        turned += 1 + 4 * fmod(n * 0.618034, 1);
        ok = draw_turned(labs, findings, lab, first + turned * texel / reach * 180 / GLM_PI, now,
                         now + PIXELS, &edge);
        flicker->lab += ok && n > 0 ? flips(now, before) : 0;
        flicker->truth += ok && n > 0 ? flips(now + PIXELS, before + PIXELS) : 0;
    }
    free(frames);
    const double length = 2 * GLM_PI * radius * edge / (FRAMES + 1),
                 scale = unit * unit * cos(closed_radians(slant)) / FRAMES / length / texel;
    flicker->lab *= scale;
    flicker->truth *= scale;
    return ok;
}

static bool run_turning(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "A sun that turns", "where the sun begins (degrees)",
                                     "flipped area per length of the edge (texels)");
    Curve *map = figure_curve(figure, "failure: shadow map", CURVE_EQUAL),
          *volumes = figure_curve(figure, "remedy: z-fail, as the truth", CURVE_EQUAL);
    const double texel = 2 * half_map / MAP, pixel = wall_seen / PICTURE;
    bool ok = true;
    for (int azimuth = 10; ok && azimuth <= 70; azimuth += 30) {
        Flicker found;
        ok = flicker(labs, findings, "03", azimuth, &found);
        if (!ok)
            break;
        curve_add(map, azimuth, found.lab, hypot(0.332, found.truth), 0.04);
        ok = flicker(labs, findings, "07", azimuth, &found);
        if (ok)
            curve_add(volumes, azimuth, found.lab, found.truth, pixel / texel / 20);
    }
    return ok;
}

const Row LAB_TABLE[] = {
    {40, "straight above", "shadow map, linear lookup, z-fail",
     "the sun, 0 to 8 degrees from straight above, in turning directions; the camera looks straight down",
     "No up vector is right for all directions: along +y the light's view has no side. Where the sun stands "
     "straight above another one is taken, and the shadow of a board is the same square as for any tilt, "
     "and lies h tan(theta) from below it. The tolerance is half a texel and half a pixel at each side.",
     "closed form", run_overhead},
    {44, "turning sun", "shadow map, z-fail",
     "the sun turns by 1 to 5 texels of the map a frame, from three azimuths on",
     "The map's grid turns with its sun, so each frame cuts the edge in texels anew, and whole texels of a "
     "step (row 18) are no cure. The wrong places of two frames are independent: the mean difference of two "
     "sums of uniform numbers, 1/3 of a texel for an edge along the grid and 0.330 along its diagonal; the "
     "truth's own flips are added as squares are, since they are small. Tolerance: four standard errors of "
     "12 "
     "independent pairs of frames along 100 texels, 0.03, and a hundredth for the ball's mesh. Volumes have "
     "no "
     "grid and flip as the truth does.",
     "closed form: Gini's mean difference of a sum of two uniform numbers", run_turning},
    {0},
};
