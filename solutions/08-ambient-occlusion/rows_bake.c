// Ambient occlusion by rays: noise, and the texels that it is kept in. A floor beside an endless wall has a
// closed form.
#include "study_faster.h"
#include "scene/atlas.h"
#include "scene/check.h"
#include "truth/closed_scenes.h"
#include "stability/row.h"
#include "stability/sight.h"

#include <math.h>

enum { WIDTH = 192, HEIGHT = 96, DENSITY = 8, TRUTH_RAYS = 256 };
static const double HALF = 2, STEP = 1 / 255.0 / 3.4641; // half the floor's side; RMS error of 8 bits

// Each texel's rays are independent, not spread evenly.
static const Change independent = {
    .name = "independent rays",
    .edits = {{"lab.c", "    for (int i = 0; i < rays; i++) {\n",
               "    Random random = {(uint64_t)texel};\n"
               "    for (int i = 0; i < rays; i++) {\n"},
              {"lab.c", "sample_pair((uint64_t)texel, i, rays)",
               "(vec2s){{random_range(&random, 0, 1), random_range(&random, 0, 1)}}"}},
    .edit_count = 2};

// The wall's ends hide less than 1e-4 more or less. The camera looks down at the floor and the wall's foot.
static Scene wall_and_floor(void) {
    Scene scene = {.camera = {.eye = vec3_make(0, 6, 0),
                              .target = vec3_make(0, 0, -0.8f),
                              .fov_y = glm_rad(30),
                              .near_plane = 1,
                              .far_plane = 20}};
    closed_add(&scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make((float)HALF, 1, (float)HALF), 0);
    closed_stand(&scene, vec3_make(0, 0.5f, (float)-HALF), 40, 0.5f, 0);
    return scene;
}

static double exact(double z) {
    return closed_beside_wall(z + HALF, 1);
}

// Draws the baked occlusion as `view` shows it, in 8 bits of grey.
static bool draw(LabArtist *artist, const Scene *scene, const char *view, MetricsSize size, int density,
                 int rays, Image *image) {
    static Reply reply;
    Setting setting = {.view = view};
    setting_knob(&setting, "texel density", (float)density);
    setting_knob(&setting, "rays", (float)rays);
    const Request request = setting_request(&setting, scene, size);
    return lab_artist_draw(artist, &request, image, &reply);
}

// RMS error of the floor's texels; `theory`: that of independent rays, each of which hits with the
// probability that is to be found.
static bool texel_error(LabArtist *artist, int density, int rays, double *error, double *theory) {
    const Scene scene = wall_and_floor();
    Atlas atlas = {0};
    Image image = {0};
    bool ok = atlas_layout(&atlas, &scene, (float)density, 1) &&
              draw(artist, &scene, "baked occlusion", (MetricsSize){atlas.width, atlas.height}, density, rays,
                   &image);
    double squares = 0, variance = 0;
    const Chart *chart = &atlas.charts[0];
    for (int i = 0; ok && i < chart->width * chart->height; i++) {
        int column = i % chart->width, row = i / chart->width;
        double expected = exact(HALF * (1 - 2 * (row + 0.5) / chart->height));
        double seen =
            image.rgba[image_at(&image, chart->left + column, atlas.height - 1 - chart->bottom - row)] /
            255.0;
        squares += (seen - expected) * (seen - expected) / (chart->width * chart->height);
        variance += expected * (1 - expected) / rays / (chart->width * chart->height);
    }
    *error = sqrt(squares);
    *theory = sqrt(variance + STEP * STEP);
    atlas_destroy(&atlas);
    image_destroy(&image);
    return ok;
}

// Does the pixel see the floor, and where?
static bool sees_floor(const Camera *camera, MetricsSize size, int pixel, double *z) {
    vec3s ray = sight_ray(camera, size, pixel % size.width, pixel / size.width);
    double depth = -camera->eye.y / ray.y, x = camera->eye.x + depth * ray.x;
    *z = camera->eye.z + depth * ray.z;
    return fabs(x) < HALF && fabs(*z) < HALF;
}

// What is left of `exact` at z when it is kept in texels and interpolated between their middles; beyond the
// last one its value goes on.
static double interpolated(double z, int density) {
    double count = 2 * HALF * density, at = fmin(fmax((z + HALF) * density - 0.5, 0), count - 1);
    double below = floor(at), middle = (below + 0.5) / density - HALF;
    return (1 - (at - below)) * exact(middle) + (at - below) * exact(middle + 1.0 / density);
}

// RMS error of the picture's floor; `resolution`: that of exact texels.
static bool picture_error(LabArtist *artist, int density, int rays, double *error, double *resolution) {
    const Scene scene = wall_and_floor();
    const MetricsSize size = {WIDTH, HEIGHT};
    Image image = {0};
    bool ok = draw(artist, &scene, VIEW_VISIBILITY, size, density, rays, &image);
    double squares = 0, left = 0, count = 0, z;
    for (int i = 0; ok && i < WIDTH * HEIGHT; i++) {
        if (!sees_floor(&scene.camera, size, i, &z))
            continue;
        double lost = interpolated(z, density) - exact(z), off = 1 - image.rgba[4 * i] / 255.0 - exact(z);
        squares += off * off;
        left += lost * lost;
        count++;
    }
    *error = sqrt(squares / count);
    *resolution = sqrt(left / count);
    image_destroy(&image);
    return ok;
}

// Of N texels the RMS of their errors is uncertain by 1 / sqrt(2 N) of itself; four times that.
static double uncertainty(int density) {
    double texels = 4 * HALF * HALF * density * density;
    return 4 / sqrt(2 * texels);
}

static bool sweep_rays(LabSet *labs, Curve *curve, const Change *change) {
    LabArtist *artist = lab_set_artist(labs, LAB_ID, change);
    bool ok = artist != NULL;
    for (int rays = 4; ok && rays <= 256; rays *= 2) {
        double error, theory;
        ok = texel_error(artist, DENSITY, rays, &error, &theory);
        if (ok)
            curve_add(curve, rays, error, theory, uncertainty(DENSITY) * theory);
    }
    return ok;
}

// A pixel's value is interpolated between four texels: of independent noise 2/3 are left on average. Noise
// and resolution add up by squares where they have nothing in common, and to their sum at most.
static bool sweep_texels(LabSet *labs, Curve *curve, int density) {
    LabArtist *artist = lab_set_artist(labs, LAB_ID, NULL);
    bool ok = artist != NULL;
    for (int rays = 4; ok && rays <= 4096; rays *= 4) {
        double error, resolution, texels, theory;
        ok = texel_error(artist, density, rays, &texels, &theory) &&
             picture_error(artist, density, rays, &error, &resolution);
        if (!ok)
            break;
        double noise = sqrt(texels * texels * 4 / 9 + STEP * STEP), both = hypot(resolution, noise);
        curve_add(curve, rays, error, both, resolution + noise - both + uncertainty(density) * noise);
    }
    return ok;
}

static bool keep_frame(LabSet *labs, Findings *findings) {
    const Scene scene = wall_and_floor();
    const TruthQuery query = {.kind = TRUTH_OCCLUSION, .samples = TRUTH_RAYS};
    Setting setting = {.view = VIEW_VISIBILITY, .object = TRUTH_NONE};
    TruthView truth_view = {0};
    Measured measured = {0};
    LabArtist *artist = lab_set_artist(labs, LAB_ID, NULL);
    setting_knob(&setting, "texel density", 1);
    setting_knob(&setting, "rays", 4);
    bool ok = artist &&
              truth_view_create(&truth_view, &scene, (MetricsSize){WIDTH, HEIGHT}, &query, artist) &&
              truth_view_measure(&truth_view, artist, &setting, false, &measured);
    if (ok)
        findings_frame(findings, 0, 0, &truth_view, &measured, "One texel a unit, four rays a texel");
    measured_destroy(&measured);
    truth_view_destroy(&truth_view);
    return ok;
}

static bool run_bake(LabSet *labs, Findings *findings) {
    Figure *noise = findings_figure(findings, "Texels beside a wall", "rays a texel", "RMS error"),
           *picture =
               findings_figure(findings, "The picture between the texels", "rays a texel", "RMS error");
    noise->log_x = noise->log_y = picture->log_x = picture->log_y = true;
    Curve *even = figure_curve(noise, "the lab's even rays", CURVE_SLOPE),
          *spheres = figure_curve(noise, "spheres first, at -O2", CURVE_SLOPE);
    even->slope = spheres->slope = -0.75;
    even->tolerance = spheres->tolerance = 0.05;
    return sweep_rays(labs, even, NULL) && sweep_rays(labs, spheres, &occlusion_spheres) &&
           sweep_rays(labs, figure_curve(noise, "independent rays", CURVE_EQUAL), &independent) &&
           sweep_texels(labs, figure_curve(picture, "1 texel a unit", CURVE_EQUAL), 1) &&
           sweep_texels(labs, figure_curve(picture, "2 texels a unit", CURVE_EQUAL), 2) &&
           sweep_texels(labs, figure_curve(picture, "4 texels a unit", CURVE_EQUAL), 4) &&
           keep_frame(labs, findings);
}

const Row LAB_TABLE[] = {
    {28, "baked occlusion", "ambient occlusion in an atlas", "4 to 4096 rays; 1 to 4 texels a unit",
     "The noise of independent rays falls with the square root of their number. Of n evenly spread ones only "
     "the strata that the wall's edge cuts are uncertain, about sqrt(n) of n, as in row 16: the noise falls "
     "as "
     "sqrt(sqrt(n)) / n, n to the power -0.75. In the picture it falls until the texels are too coarse: what "
     "is interpolated between exact "
     "values is the floor under the error, and only more texels lower it.",
     "closed form", run_bake},
    {0},
};
