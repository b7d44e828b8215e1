// What luxels lose: an edge becomes a ramp of one luxel, smooth light is cut into straight lines, and without
// padding the borders of a chart are mixed with what lies beside it.
#include "scene/count.h"
#include "stability/probe.h"
#include "stability/row.h"
#include "truth/closed_scenes.h"

#include <math.h>

enum { WIDTH = 1024, HEIGHT = 64, SIDE = 200 };
static const double half = 2;                    // of the wall's side
static const double unit = 4.4 / WIDTH;          // of a pixel of the wide picture, world units
static const double lamp_height = 1, peak = 0.9; // of the lamp without casters, and its light under it

static const Change bare = {
    .name = "no dilation",
    .edits = {{"dilate.frag", "int nearest = o_luxel.a > 0.0 ? 0 : 1000000", "int nearest = 0"}},
    .edit_count = 1};

// A wall in a wide, low picture, under a sun from the right.
static Scene wide_wall(void) {
    Scene scene = closed_wall((float)half, 10, (float)(2 * atan(unit * HEIGHT / 20)));
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(6, 0, 6), vec3_make(0, 0, 0), 0, 5, 1, 20);
    return scene;
}

// Of the pixels of the middle row, from left to right.
static double place_of(int column) {
    return (column + 0.5 - WIDTH / 2.0) * unit;
}

static double seen_at(const Probe *probe, int column) {
    return probe->measured.visibility[(size_t)(HEIGHT / 2) * WIDTH + (size_t)column];
}

// The wrong light along the middle row, and how far from the edge it reaches. A plate one unit before the
// wall hides the lamp to the right of the edge, and the wall to the right of its own.
static void measure_edge(const Probe *probe, double edge, double *wrong, double *reach) {
    *wrong = *reach = 0;
    for (int x = 0; x < WIDTH; x++) {
        double at = place_of(x);
        if (fabs(at) > half || at > (edge + 1) * 10 / 9 - 2 * unit)
            continue;
        double off = fabs(seen_at(probe, x) - (at < edge));
        *wrong += off * unit;
        if (off > 0.5 / 255)
            *reach = fmax(*reach, fabs(at - edge));
    }
}

// Between the middles a luxel apart the light falls linearly. Of an edge the part t of a luxel behind a
// middle, s / 2 (t^2 + (1 - t)^2) is wrong.
static double expected_wrong(double edge, double s) {
    double at = (edge + half) / s - 0.5, t = at - floor(at);
    return s / 2 * (t * t + (1 - t) * (1 - t));
}

static bool add_edge(LabSet *labs, Findings *findings, Curve *curve, Curve *reach_curve, double edge,
                     int density) {
    Scene scene = wide_wall();
    double wrong, reach, s = 1.0 / density;
    Probe probe;
    closed_add(&scene, SHAPE_BOX, vec3_make((float)edge + 3, 0, 1), vec3_make(2, 2, 1e-5f), 0);
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, WIDTH, HEIGHT);
    probe_knob(&probe, "luxel density", density);
    ok = ok && probe_draw(&probe);
    if (ok) {
        measure_edge(&probe, edge, &wrong, &reach);
        curve_add(curve, density, wrong, expected_wrong(edge, s), unit / 2 + s / 255);
        if (reach_curve)
            curve_add(reach_curve, density, reach, s, unit);
        findings_frame(findings, 0, -density, &probe.truth_view, &probe.measured, "%d luxels a unit",
                       density);
    }
    probe_end(&probe);
    return ok;
}

// Light that is missing along the middle row of a wall that is lit all over: at its ends the luxels are mixed
// with black ones, half and half at the border. That is 1/8 of a luxel at each end.
static bool add_seam(LabSet *labs, Findings *findings, Curve *curve, const Change *change, int density) {
    const Scene scene = wide_wall();
    double missing = 0, s = 1.0 / density;
    Probe probe;
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, WIDTH, HEIGHT);
    probe_knob(&probe, "luxel density", density);
    probe.change = change;
    ok = ok && probe_draw(&probe);
    for (int x = 0; ok && x < WIDTH; x++)
        if (fabs(place_of(x)) < half)
            missing += (1 - seen_at(&probe, x)) * unit;
    if (ok && change)
        findings_frame(findings, 1, -density, &probe.truth_view, &probe.measured,
                       "Not padded, %d luxels a unit", density);
    if (ok)
        curve_add(curve, density, missing, change ? s / 4 : 0, change ? unit + s / 255 : 0);
    probe_end(&probe);
    return ok;
}

// I cos / r^2 at the distance from the place under the lamp, 1 at most `peak`.
static double light_at(double x, double y) {
    double h = lamp_height, r2 = x * x + y * y + h * h;
    return peak * h * h * h / (r2 * sqrt(r2));
}

// What is left of it when it is kept in luxels.
static double interpolated(double x, double y, int density) {
    double sum = 0, u = (x + half) * density - 0.5, v = (y + half) * density - 0.5;
    for (int i = 0; i < 4; i++) {
        double a = floor(u) + i % 2, b = floor(v) + floor(i / 2.0);
        sum += (1 - fabs(u - a)) * (1 - fabs(v - b)) *
               light_at((a + 0.5) / density - half, (b + 0.5) / density - half);
    }
    return sum;
}

// A white wall under a lamp without shadows: where it is brightest its second derivatives are -3 I / h^4
// each, and a straight line over s misses s^2 / 8 of each.
static bool add_smooth(LabSet *labs, Curve *rms, Curve *most, Curve *slope, int density) {
    static Reply reply;
    Scene scene = closed_wall((float)half, 10, 2 * atanf(0.16f));
    closed_light(&scene, LIGHT_POINT, vec3_make(0, 0, (float)lamp_height), vec3_make(0, 0, 0), 1, 0, 0.5f,
                 20);
    float intensity = (float)(peak * lamp_height * lamp_height);
    scene.lights[0].color = vec3_make(intensity, intensity, intensity);
    Setting setting = {.view = "picture"};
    setting_knob(&setting, "luxel density", (float)density);
    Image image = {0};
    LabArtist *artist = lab_set_artist(labs, LAB_ID, NULL);
    const Request request = setting_request(&setting, &scene, (MetricsSize){SIDE, SIDE});
    bool ok = artist && lab_artist_draw(artist, &request, &image, &reply);
    double pixel = closed_unit(&scene, SIDE), squares = 0, lost = 0, worst = 0, s = 1.0 / density;
    for (int i = 0; ok && i < SIDE * SIDE; i++) {
        double x = (i % SIDE + 0.5 - SIDE / 2.0) * pixel,
               y = (SIDE / 2.0 - 0.5 - floor((double)i / SIDE)) * pixel;
        double exact = light_at(x, y), off = image.rgba[4 * i] / 255.0 - exact;
        squares += off * off / (SIDE * SIDE);
        lost += pow(interpolated(x, y, density) - exact, 2) / (SIDE * SIDE);
        worst = fmax(worst, fabs(off));
    }
    if (ok) {
        const double step = 1 / 255.0 / sqrt(12); // RMS of what bytes round away
        curve_add(rms, density, sqrt(squares), hypot(sqrt(lost), step), 0.3 / 255);
        curve_add(most, density, worst, 0.75 * s * s * peak / pow(lamp_height, 2), 0.6 / 255 + 0x1p-11);
        curve_add(slope, density, sqrt(fmax(squares - step * step, 0)), 0, 0);
    }
    image_destroy(&image);
    return ok;
}

static bool run_light_map(LabSet *labs, Findings *findings) {
    Figure *edge = findings_figure(findings, "A hard edge in luxels", "luxels a unit", "wrong light (units)"),
           *seam = findings_figure(findings, "The ends of a chart", "luxels a unit", "missing light (units)"),
           *smooth = findings_figure(findings, "Smooth light in luxels", "luxels a unit", "error");
    edge->log_x = edge->log_y = smooth->log_x = smooth->log_y = true;
    Curve *anywhere = figure_curve(edge, "an edge anywhere", CURVE_EQUAL),
          *middle = figure_curve(edge, "an edge between two luxels", CURVE_SLOPE),
          *reach = figure_curve(edge, "how far it reaches (a luxel at most)", CURVE_MOST),
          *padded = figure_curve(seam, "padded", CURVE_EQUAL),
          *black = figure_curve(seam, "failure: not padded", CURVE_EQUAL),
          *rms = figure_curve(smooth, "RMS", CURVE_EQUAL),
          *most = figure_curve(smooth, "largest", CURVE_MOST),
          *slope = figure_curve(smooth, "RMS less the rounding", CURVE_SLOPE);
    const int some[] = {2, 3, 5, 6, 7, 9, 11, 13, 15};
    middle->slope = -1;
    slope->slope = -2;
    middle->tolerance = slope->tolerance = 0.1;
    bool ok = true;
    for (size_t i = 0; ok && i < COUNT(some); i++)
        ok = add_edge(labs, findings, anywhere, reach, -0.437, some[i]);
    for (int density = 2; ok && density <= 16; density *= 2)
        ok = add_edge(labs, findings, middle, NULL, -0.5, density) &&
             add_seam(labs, findings, padded, NULL, density) &&
             add_seam(labs, findings, black, &bare, density);
    for (int density = 2; ok && density <= 8; density++)
        ok = add_smooth(labs, rms, most, slope, density);
    return ok;
}

const Row LAB_TABLE[] = {
    {31, "light maps", "light kept in the texels of the scene", "2 to 16 luxels a unit",
     "A hard edge becomes a ramp between the middles of two luxels: what is wrong falls with the luxel's "
     "side, and reaches a luxel far at most. Smooth light is cut into straight pieces: that falls with the "
     "square of the side, and is at most 3 s^2 / (4 h^4) I under a lamp I at the height h. Without padding "
     "1/8 of a luxel is missing at each end of a chart; padded nothing is.",
     "closed form", run_light_map},
    {0},
};
