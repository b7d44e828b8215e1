// Soft edges: what a filter of a given width makes of a straight edge. A plate before a wall under light from
// the left, 45 degrees aslant; the edge lies on a border of texels, so that each comparison is right.
#include "study_filters.h"
#include "scene/count.h"
#include "truth/closed_scenes.h"
#include "stability/probe.h"
#include "stability/row.h"

// Integrals of the error and of its square across the edge, in texels, over the rows of the picture.
static void integrate(const Probe *probe, double texel, double *error, double *square) {
    const MetricsSize size = probe->truth_view.size;
    double step = probe_unit(probe) * M_SQRT1_2 / texel / size.height;
    *error = *square = 0;
    for (int i = 0; i < size.width * size.height; i++) {
        double off = fabsf(probe->measured.visibility[i] - probe->truth_view.visibility[i]);
        *error += off * step;
        *square += off * off * step;
    }
}

enum { WIDTH = 800, ROWS = 8, MAP = 128, BOX = 4, GATHER = 5 };
static const float half_size = 4;

static bool begin_edge(Probe *probe, LabSet *labs) {
    Scene scene = closed_wall(6, 10, 2 * atanf(4.0F * ROWS / WIDTH / 20));
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(-6, 0, 6), vec3_make(0, 0, 0), 0, half_size, 1, 14);
    closed_add(&scene, SHAPE_BOX, vec3_make(-4, 0, 2), vec3_make(2, 3, 0.001F), 0);
    return probe_begin(probe, labs, LAB_ID, &scene, WIDTH, ROWS);
}

static bool run_box(LabSet *labs, Findings *findings) {
    const double texel = 2 * half_size / MAP;
    Figure *figure = findings_figure(findings, "A straight edge", "width w of the kernel (texels)",
                                     "error across the edge (texels)");
    Curve *error = figure_curve(figure, "absolute error: w / 4", CURVE_EQUAL);
    Curve *square = figure_curve(figure, "squared error: w / 12", CURVE_EQUAL);
    Probe probe;
    bool ok = begin_edge(&probe, labs);
    probe_knob(&probe, "method", BOX);
    probe_knob(&probe, "map size", MAP);
    for (int k = 0; ok && k <= 8; k++) {
        double w = 2 * k + 1, pixel = probe_unit(&probe) * M_SQRT1_2 / texel, linear, squared;
        probe_knob(&probe, "kernel radius", k);
        ok = probe_draw(&probe);
        if (!ok)
            break;
        integrate(&probe, texel, &linear, &squared);
        // A picture has 255 steps and a driver's filter 256: two steps over the kernel's width; and the sum
        // over pixels errs by a part of one where the truth jumps.
        curve_add(error, w, linear, w / 4, w * 2 / 255 + pixel / 4);
        curve_add(square, w, squared, w / 12, w / 255 + pixel / 4);
        findings_frame(findings, 0, w, &probe.truth_view, &probe.measured,
                       "A box of %d x %d texels (%d rows are drawn)", (int)w, (int)w, ROWS);
    }
    probe_end(&probe);
    return ok;
}

// The other filters, in texels: `width` of what they make of the edge, `jumps` of it (of three nearest texels
// at both ends), and the integrals. Three texels: 1/3 beside the edge, a texel far on both sides. Two ramps
// of one texel, two texels apart, half as high: 1/4 from their slopes, twice, and 1/2 from between them. A
// tent: ramps of one texel with the slopes 1/4, 1/2, 1/4, so 2 (1/8 + 3/16) and 2 (1/48 + 7/96). A box in
// fewer lookups is the box.
typedef struct Profile {
    const char *name;
    int method, radius;
    double width, jumps, error, square;
    const Change *change; // a way to the same in less time (study_faster.c); NULL: the lab's own
} Profile;

static const Profile own[] = {{"hard: 0", 0, 0, 0, 0, 0, 0, NULL},
                              {"3 x 3 by hand: 2/3", 1, 0, 2, 2 / 3.0, 2 / 3.0, 2 / 9.0, NULL},
                              {"linear: 1/4", 2, 0, 1, 0, 1 / 4.0, 1 / 12.0, NULL},
                              {"4 diagonals: 1", 3, 0, 3, 0, 1, 5 / 12.0, NULL},
                              {"3 x 3 by gathers: 3/4", GATHER, 0, 3, 0, 3 / 4.0, 3 / 12.0, NULL}},
                     faster[] = {
                         {"3 x 3 tent by gathers: 5/8", GATHER, 0, 3, 0, 5 / 8.0, 3 / 16.0, &filter_tent},
                         {"box 5 x 5, 9 gathers: 5/4", BOX, 2, 5, 0, 5 / 4.0, 5 / 12.0, &filter_gathers},
                         {"box 5 x 5, 9 between texels: 5/4", BOX, 2, 5, 0, 5 / 4.0, 5 / 12.0,
                          &filter_between}};

static bool sweep_profile(LabSet *labs, const Profile *profile, Curve *error, Curve *square) {
    Probe probe;
    bool ok = begin_edge(&probe, labs);
    probe.change = profile->change;
    probe_knob(&probe, "method", profile->method);
    probe_knob(&probe, "kernel radius", profile->radius);
    for (int map = MAP / 2; ok && map <= 2 * MAP; map *= 2) {
        double texel = 2 * half_size / map, pixel = probe_unit(&probe) * M_SQRT1_2 / texel, linear, squared,
               sum = (0.25 + profile->jumps / 2) * pixel;
        probe_knob(&probe, "map size", map);
        ok = probe_draw(&probe);
        if (!ok)
            break;
        integrate(&probe, texel, &linear, &squared);
        curve_add(error, map, linear, profile->error, profile->width * 2 / 255 + sum);
        curve_add(square, map, squared, profile->square, profile->width / 255 + sum);
    }
    probe_end(&probe);
    return ok;
}

static bool sweep_profiles(LabSet *labs, Findings *findings, const char *title, const Profile *profiles,
                           size_t count) {
    Figure *errors = findings_figure(findings, title, "map size (texels a side)",
                                     "absolute error across the edge (texels)"),
           *squares = findings_figure(findings, "The same, squared", "map size (texels a side)",
                                      "squared error across the edge (texels)");
    bool ok = true;
    for (size_t i = 0; ok && i < count; i++)
        ok = sweep_profile(labs, &profiles[i], figure_curve(errors, profiles[i].name, CURVE_EQUAL),
                           figure_curve(squares, profiles[i].name, CURVE_EQUAL));
    return ok;
}

static bool run_filters(LabSet *labs, Findings *findings) {
    return run_box(labs, findings) &&
           sweep_profiles(labs, findings, "A straight edge by the other filters", own, COUNT(own));
}

static bool run_fewer(LabSet *labs, Findings *findings) {
    return sweep_profiles(labs, findings, "A straight edge in fewer lookups", faster, COUNT(faster));
}

const Row LAB_TABLE[] = {
    {15, "PCF blur", "percentage-closer filtering", "the kernel's width w, 1 to 17 texels; the map's size",
     "A box of width w makes a ramp as wide of a hard edge: w / 4 of absolute error per length of the edge, "
     "w / 12 of squared error. Softness that no real penumbra asked for is an error that grows with the "
     "kernel. Each other filter has its own share of a texel, whatever the map's size.",
     "closed form", run_filters},
    {100 * LAB_NUMBER + 2, "filters in fewer lookups", "percentage-closer filtering, faster",
     "the map's size",
     "A box of 5 x 5 from 9 gathers or from 9 lookups between texels makes the box's ramp: 5 / 4 of a texel, "
     "and 5 / 12 squared. "
     "A tent from four gathers has ramps of three slopes: 5 / 8, and 3 / 16. No lab has them; they are edits "
     "of lab 05's shader.",
     "closed form; I. Castano: Shadow Mapping Summary, 2013", run_fewer},
    {0},
};
