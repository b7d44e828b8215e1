// How many bits a depth needs. A spot light's map stores z = f (d - n) / (d (f - n)): near the far plane a
// step q of the depth is q d^2 (f - n) / (f n) in the world, the more the nearer the near plane n.
#include "truth/closed_scenes.h"
#include "stability/probe.h"
#include "stability/row.h"
#include "stability/tilted.h"

enum { SIDE = 200, CONSTANT = 1, STEPS = 10, PLANES = 6 };
static const double far_plane = 20, fov = 8, distance = 5;

// A patch of a wall, half a unit wide, on the light's axis and tilted by 60 degrees from it: its depths
// differ by more than a step of 16 bits for every near plane.
static Scene patch(double near_plane) {
    Scene scene = tilted_wall(60, 25, 1, 1);
    Light *light = &scene.lights[0];
    light->kind = LIGHT_SPOT;
    light->position = glms_vec3_scale(glms_vec3_normalize(light->position), (float)distance);
    light->fov_y = glm_rad((float)fov);
    light->near_plane = (float)near_plane;
    light->far_plane = (float)far_plane;
    scene.camera.fov_y = 2 * atanf(0.25F / scene.camera.eye.z);
    return scene;
}

// World units that a step of the depth is on the patch.
static double world_from_depth(double near_plane) {
    return distance * distance * (far_plane - near_plane) / (far_plane * near_plane);
}

// The least bias (depth) without acne, by bisection of its logarithm between `most` and a part of it.
static bool least_bias(Probe *probe, double most, double *bias) {
    double low = log(most / 200), high = log(most);
    for (int i = 0; i < STEPS; i++) {
        double middle = (low + high) / 2;
        probe_knob(probe, "bias", exp(middle));
        if (!probe_draw(probe))
            return false;
        *(probe->measured.metrics.all.false_shadow > 0 ? &low : &high) = middle;
    }
    *bias = exp(high);
    return true;
}

// The map of 16 bits is rounded to the nearest step (which OpenGL prefers and does not demand): half a step
// is lost. With 24 bits and more the step is that of float arithmetic, which rounds about a dozen times on
// its way to the map and to z - bias, by up to half a step either way. What that may come to must stay small
// beside what is expected, or any bias would do: those formats get a map so coarse, and near planes so far,
// that the slope's part is three times as large at least.
typedef struct Format {
    const char *name;
    int bits;
    double lost; // depth
    int map;     // texels along a side
    int first;   // of the near planes
} Format;

static const double float_step = 1.0 / (1 << 24);
static const Format formats[] = {
    {"16 bits", 16, 0.5 / 65535, 2048, 0}, {"24 bits", 24, 0, 64, 1}, {"32 bits (float)", 32, 0, 64, 1}};

// Of SIDE^2 pixels one comes as near as their cube root to the worst place in a texel, in x and y, and to the
// worst rounding; the patch's depth differs by 4.3 % to each side, and the slope's part as much.
static double bias_tolerance(double slope, double expected, double world) {
    return 6 * float_step * world + expected / cbrt((double)SIDE * SIDE) + 0.05 * slope;
}

static bool add_near(LabSet *labs, Findings *findings, Curve *curve, const Format *format,
                     double near_plane) {
    const Scene scene = patch(near_plane);
    double texel = 2 * distance * tan(closed_radians(fov) / 2) / format->map,
           slope = texel / 2 * tilted_slope(&scene);
    double world = world_from_depth(near_plane), expected = slope + format->lost * world, bias;
    double tolerance = bias_tolerance(slope, expected, world);
    Probe probe;
    bool ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE);
    probe_knob(&probe, "method", CONSTANT);
    probe_knob(&probe, "map size", format->map);
    probe_knob(&probe, "depth format", format->bits);
    ok = ok && least_bias(&probe, 4 * (expected + tolerance) / world, &bias);
    if (ok) {
        curve_add(curve, near_plane, bias * world, expected, tolerance);
        probe_knob(&probe, "bias", slope / world);
        ok = probe_draw(&probe);
        findings_frame(findings, 0, probe.measured.metrics.all.false_shadow, &probe.truth_view,
                       &probe.measured, "%s, near plane at %g: the bias that is enough for the slope",
                       format->name, near_plane);
    }
    probe_end(&probe);
    return ok;
}

static bool run_depth_bits(LabSet *labs, Findings *findings) {
    static const double planes[PLANES] = {0.001, 0.003, 0.01, 0.03, 0.1, 1};
    Figure *figure = findings_figure(findings, "Bias that ends acne on a patch 5 from the light",
                                     "near plane (world units)", "bias (world units)");
    figure->log_x = figure->log_y = true;
    bool ok = true;
    for (int f = 0; ok && f < 3; f++) {
        Curve *curve = figure_curve(figure, formats[f].name, CURVE_EQUAL);
        for (int i = formats[f].first; ok && i < PLANES; i++)
            ok = add_near(labs, findings, curve, &formats[f], planes[i]);
    }
    Curve *power = figure_curve(figure, "16 bits, up to 0.03", CURVE_SLOPE);
    power->slope = -1;
    power->tolerance = 0.05; // at 0.03 the slope's part is 6 %
    for (int i = 0; ok && i < 4; i++)
        curve_add(power, planes[i], figure->curves[0].points[i].measured, 0, 0);
    return ok;
}

const Row LAB_TABLE[] = {
    {12, "depth bits", "constant bias, by the format of the depth", "the light's near plane n, 0.001 to 1",
     "The slope's part, which no format changes, and half a step of the depth, q d^2 (f - n) / (f n) in the "
     "world: with 16 bits the bias goes as 1 / n until the slope's part dominates. 24 bits and 32 bits of "
     "float are alike, because the shader's own arithmetic is float: six of its steps, a dozen roundings, "
     "are "
     "tolerated, and a coarser map keeps them below a third of the slope's part.",
     "closed form", run_depth_bits},
    {0},
};
