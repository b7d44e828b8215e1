// What a wide filter kernel needs: lab 05's box of 2 k + 1 taps along x and y, whose linear lookups reach m =
// k + 1 texels. The wall's slope lies along the map's x axis, so all rows of the picture are alike.
#include "study_receiver_plane.h"
#include "stability/probe.h"
#include "stability/row.h"
#include "stability/tilted.h"

enum { WIDTH = 200, ROWS = 8, MAP = 128, BOX = 4, MOST_RADIUS = 7, STEPS = 10 };
static const float half_size = 4;

// Lab 05 derives its polygon offset from the kernel; the sweep needs it as a knob.
#define FACTOR_KNOB                                                                                          \
    {"lab.c", ".knobs = {",                                                                                  \
     ".knobs = {[KNOB_MAP_SIZE + 1] = {\"factor\", \"slopes per texel\", 0, 64, 1}, "},                      \
    {                                                                                                        \
        "lab.c", "glPolygonOffset(2 * reach, 2)",                                                            \
            "glPolygonOffset(frame->knobs[KNOB_MAP_SIZE + 1] + 0 * reach, 2)"                                \
    }

static const Change plain = {.name = "polygon offset as a knob", .edits = {FACTOR_KNOB}, .edit_count = 2};

static const Change receiver_plane = {
    .name = "receiver-plane depth bias", .edits = {FACTOR_KNOB, RECEIVER_PLANE}, .edit_count = 4};

static bool begin(Probe *probe, LabSet *labs, const Scene *scene, int width, const Change *change) {
    bool ok = probe_begin(probe, labs, LAB_ID, scene, width, ROWS);
    probe->change = change;
    probe_knob(probe, "method", BOX);
    probe_knob(probe, "map size", MAP);
    return ok;
}

// The least factor without acne, by bisection from 0 to `most`.
static bool least_factor(Probe *probe, double most, double *factor) {
    double low = 0, high = most;
    for (int i = 0; i < STEPS; i++) {
        double middle = (low + high) / 2;
        probe_knob(probe, "factor", middle);
        if (!probe_draw(probe))
            return false;
        *(probe->measured.metrics.all.false_shadow > 0 ? &low : &high) = middle;
    }
    *factor = high;
    return true;
}

// `slope`: 1 when the offset must grow with k, 0 when it need not. A picture has 255 steps: a part f of the
// outermost texels, of weight 1 / (2 k + 1), shows when it is more than (2 k + 1) / 510 (all taps alike: 1 /
// 510), and WIDTH phases come as near to that as a few of them. So the least factor lies a little below m.
static bool sweep_least(LabSet *labs, Findings *findings, Curve *curve, const Change *change, double slope) {
    const Scene scene = tilted_wall(60, 0, half_size, (double)WIDTH / ROWS);
    Probe probe;
    bool ok = begin(&probe, labs, &scene, WIDTH, change);
    for (int k = 0; ok && k <= MOST_RADIUS; k++) {
        double expected = 1 + slope * k, most = 2 * (k + 1), factor,
               below = (2 * slope * k + 1) / 510 + 4.0 / WIDTH;
        probe_knob(&probe, "kernel radius", k);
        ok = least_factor(&probe, most, &factor);
        if (!ok)
            break;
        curve_add(curve, k, factor, expected - below / 2, below / 2 + most / (1 << STEPS));
        probe_knob(&probe, "factor", 0.5 * expected);
        ok = probe_draw(&probe);
        findings_frame(findings, 0, k, &probe.truth_view, &probe.measured,
                       "k = %d and half of the offset that it needs (only %d rows are drawn)", k, ROWS);
    }
    probe_end(&probe);
    return ok;
}

static bool run_wide(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "Offset that ends acne", "kernel radius k (texels)",
                                     "polygon offset's factor (slopes per texel)");
    return sweep_least(labs, findings, figure_curve(figure, "box of linear lookups", CURVE_EQUAL), &plain, 1);
}

// A wall and a box on it, 45 degrees to the light both: in the map the depth is -|u|. At u0 on the wall, the
// plane of the wall gives a tap at u < 0 the depth -u, behind the box by 2 |u|.
static Scene corner(void) {
    Scene scene = tilted_wall(45, 0, half_size, 2.0 * WIDTH / ROWS);
    closed_add(&scene, SHAPE_BOX, vec3_make(2, 0, 1), vec3_make(2, 6, 1), 0);
    return scene;
}

// False shadow on the wall for each unit of the corner's length, in texels.
static double crease_width(const Probe *probe) {
    const TruthView *truth_view = &probe->truth_view;
    double dark = 0, unit = probe_unit(probe);
    for (size_t i = 0; i < (size_t)truth_view->size.width * ROWS; i++)
        if (truth_view->picture.hits[i].object == 0)
            dark += 1 - probe->measured.visibility[i];
    return dark / ROWS * unit * M_SQRT1_2 / (2 * half_size / MAP);
}

// Of the texels at |u| = 1.5, 2.5, ... beyond the corner all are dark for the taps that reach them, with the
// factor 2; the one at 0.5 is not. Summed over the wall's points: k (k - 1) / 2 of 2 k + 1.
static bool sweep_crease(LabSet *labs, Findings *findings, Curve *curve, const Change *change) {
    const Scene scene = corner();
    Probe probe;
    bool ok = begin(&probe, labs, &scene, 2 * WIDTH, change);
    for (int k = 1; ok && k <= MOST_RADIUS; k++) {
        bool extrapolates = change == &receiver_plane;
        double pixel = probe_unit(&probe) * M_SQRT1_2 / (2 * half_size / MAP);
        probe_knob(&probe, "kernel radius", k);
        probe_knob(&probe, "factor", extrapolates ? 2 : 2 * (k + 1));
        ok = probe_draw(&probe);
        if (!ok)
            break;
        double expected = extrapolates ? k * (k - 1) / 2.0 / (2 * k + 1) : 0;
        curve_add(curve, k, crease_width(&probe), expected, extrapolates ? pixel / 4 + k / 510.0 : 0);
        findings_frame(findings, 1, crease_width(&probe), &probe.truth_view, &probe.measured,
                       "Receiver-plane bias beside a box that stands on the wall, k = %d", k);
    }
    probe_end(&probe);
    return ok;
}

static bool run_receiver_plane(LabSet *labs, Findings *findings) {
    Figure *plane = findings_figure(findings, "On the plane: offset that ends acne",
                                    "kernel radius k (texels)", "polygon offset's factor (slopes per texel)");
    Figure *crease = findings_figure(findings, "At a crease", "kernel radius k (texels)",
                                     "false shadow beside it (texels wide)");
    return sweep_least(labs, findings, figure_curve(plane, "receiver plane", CURVE_EQUAL), &receiver_plane,
                       0) &&
           sweep_crease(labs, findings, figure_curve(crease, "failure: receiver plane", CURVE_EQUAL),
                        &receiver_plane) &&
           sweep_crease(labs, findings, figure_curve(crease, "offset of 2 (k + 1) instead", CURVE_EQUAL),
                        &plain);
}

const Row LAB_TABLE[] = {
    {4, "wide kernels", "percentage-closer filtering", "the kernel's radius k, 0 to 7",
     "The offset that ends acne grows in proportion to m = k + 1, how far the outermost texel lies that a "
     "point asks.",
     "closed form", run_wide},
    {5, "receiver-plane bias", "percentage-closer filtering with receiver-plane depth bias",
     "the kernel's radius k, on a plane and beside a crease",
     "On a plane the offset for one linear lookup is enough for every kernel. Beside a box that stands on "
     "the wall the plane goes on behind the box: a false shadow of k (k - 1) / (4 k + 2) texels, which "
     "grows with the kernel. No lab has this bias; it is measured as an edit of lab 05's shader.",
     "closed form; J. Isidoro: Shadow Mapping: GPU-based Tips and Techniques, GDC 2006", run_receiver_plane},
    {0},
};
