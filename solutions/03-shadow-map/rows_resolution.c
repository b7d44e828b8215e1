// What the size of a texel costs at the shadow's edge. A hard map puts the edge onto texels of side s: for an
// edge at the angle phi to their axes it errs by an area of s E|cos(phi) X + sin(phi) Y| per length, X and Y
// uniform in
// [-1/2, 1/2]: s / 4 along an axis, 0.2357 s along the diagonal, 0.2436 s on average over all directions.
#include "truth/closed_scenes.h"
#include "stability/probe.h"
#include "stability/row.h"

#include <string.h>

enum { SEED = 13, PLACES = 8, FLOORS = 24, SIZES = 5, BINS = 4 };

// That mean, for an edge along the unit vector (x, y), in texels.
static double edge_error(double x, double y) {
    double a = fmax(fabs(x), fabs(y)), b = fmin(fabs(x), fabs(y));
    return a / 4 + b * b / (12 * a);
}

// Four standard errors, relative, of an area that `texels` texels (each with a standard deviation of 0.58 of
// the mean) make up and that shows as `pixels` pixels.
static double tolerance_of(double texels, double pixels) {
    return 4 * sqrt(0.58 * 0.58 / texels + 1 / pixels);
}

// Pixels that say something else than the truth, in a row of the picture.
static double wrong_pixels(const Probe *probe, int row) {
    double wrong = 0;
    int width = probe->truth_view.size.width;
    for (int i = row * width; i < (row + 1) * width; i++)
        if (probe->measured.mask[i])
            wrong += fabsf(probe->measured.visibility[i] - probe->truth_view.visibility[i]);
    return wrong;
}

// A plate high over a long floor (the wall z = 0), its edge going away from the camera's foot at the angle
// phi; light from above. The edge falls anywhere among the pixels, and anywhere among the texels; all
// of it but the light stands `aside`.
static Scene long_floor(double phi, Random *random, float half_size, float eye_height, float aside) {
    Scene scene = closed_wall(half_size, 1, glm_rad(60));
    vec3s foot = vec3_make(aside + random_range(random, -0.1F, 0.1F), -half_size, 6);
    mat4s turned = glms_rotate(glms_translate_make(foot), -(float)phi, vec3_make(0, 0, 1));
    vec3s above = vec3_make(random_range(random, -0.1F, 0.1F), random_range(random, -0.1F, 0.1F), 9);
    closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, 0), vec3_make(10, 80, 0.01F), 0);
    scene.objects[1].world_from_object =
        glms_mat4_mul(glms_translate(turned, vec3_make(-10, 0, 0)), scene.objects[1].world_from_object);
    scene.camera.eye = vec3_make(aside, -half_size, eye_height);
    scene.camera.target = vec3_make(aside, 0, eye_height - half_size * 0.35F);
    scene.camera.near_plane = 0.1F;
    scene.camera.far_plane = 3 * half_size;
    closed_light(&scene, LIGHT_DIRECTIONAL, above, vec3_make(above.x, above.y, 0), 0, half_size, 1, 12);
    return scene;
}

typedef struct Bin {
    double depth, rows, wrong, expected, texels; // texels: that the edge crosses
} Bin;

enum { WIDTH = 160, HEIGHT = 600, ONE_MAP = 1024, CASCADES = 4, CASCADE_MAP = 128 };
static const double half_floor = 24, angle = 5, nearest = 2.5;

// A texel of the one map, and of the cascade that a point at this depth before the camera asks: logarithmic
// slices, each in its smallest sphere, one texel more all around (lab 15).
static double one_texel(const Camera *camera, double depth) {
    (void)camera;
    (void)depth;
    return 2 * half_floor / ONE_MAP;
}

static double cascade_texel(const Camera *camera, double depth) {
    const double n = (double)camera->near_plane, ratio = pow((double)camera->far_plane / n, 1.0 / CASCADES);
    const double begin = n * pow(ratio, floor(log(depth / n) / log(ratio))), end = begin * ratio;
    const double k = tan(0.5 * (double)camera->fov_y) * hypot(1, (double)WIDTH / HEIGHT);
    const double centre = fmin((begin + end) * (1 + k * k) / 2, end);
    return 2 * hypot(end - centre, end * k) / (CASCADE_MAP - 2);
}

// Depth of a point before the camera.
static double view_depth(const Probe *probe, vec3s position) {
    const Camera *camera = &probe->truth_view.truth.scene.camera;
    vec3s forward = glms_vec3_normalize(glms_vec3_sub(camera->target, camera->eye));
    return glms_vec3_dot(forward, glms_vec3_sub(position, camera->eye));
}

// Adds the picture's rows, each of which shows one depth of the floor, to bins of an octave each from
// `nearest` on.
static void add_rows(const Probe *probe, double (*texel)(const Camera *camera, double depth), Bin *bins) {
    const MetricsSize size = probe->truth_view.size;
    const TruthHit *hits = probe->truth_view.picture.hits;
    const Camera *camera = &probe->truth_view.truth.scene.camera;
    const double cosine = cos(closed_radians(angle)), error = edge_error(cosine, sin(closed_radians(angle)));
    double per_depth = 2 * tan(0.5 * camera->fov_y) / size.height; // of a pixel's width
    for (int row = 1; row < size.height; row++) {
        const TruthHit *hit = &hits[row * size.width + size.width / 2], *above = hit - size.width;
        if (hit->object != 0 || above->object != 0)
            continue;
        double depth = view_depth(probe, hit->position), unit = depth * per_depth;
        int bin = (int)floor(log2(depth / nearest));
        if (bin < 0 || bin >= BINS)
            continue;
        bins[bin].depth += depth;
        bins[bin].rows++;
        bins[bin].wrong += wrong_pixels(probe, row);
        bins[bin].expected += texel(camera, depth) * error / cosine / unit;
        bins[bin].texels += (above->position.y - hit->position.y) / cosine / texel(camera, depth);
    }
}

// The tolerance of an exponent fitted to points with these tolerances.
static double slope_tolerance(const Curve *curve) {
    double mean = 0, squares = 0, sum = 0;
    for (int i = 0; i < curve->count; i++)
        mean += log(curve->points[i].x) / curve->count;
    for (int i = 0; i < curve->count; i++) {
        double u = log(curve->points[i].x) - mean, t = curve->points[i].tolerance / curve->points[i].expected;
        squares += u * u;
        sum += u * u * t * t;
    }
    return sqrt(sum) / squares;
}

static void add_slope(Figure *figure, const Curve *points, const char *name, double slope) {
    Curve *curve = figure_curve(figure, name, CURVE_SLOPE);
    curve->slope = slope;
    curve->tolerance = slope_tolerance(points);
    memcpy(curve->points, points->points, sizeof curve->points);
    curve->count = points->count;
}

// Draws the floors by a lab; `curve`: by octaves of the distance.
static bool sweep_floors(LabSet *labs, Findings *findings, Curve *curve, bool cascades) {
    Random random = {SEED};
    Bin bins[BINS] = {{0}};
    bool ok = true;
    for (int i = 0; ok && i < FLOORS; i++) {
        // The cascades' grid stands still in the world: texels of up to 0.8 units fall anywhere.
        float aside = cascades ? random_range(&random, -0.8F, 0.8F) : 0;
        const Scene scene = long_floor(closed_radians(angle), &random, (float)half_floor, 2, aside);
        Probe probe;
        ok = probe_begin(&probe, labs, cascades ? "15" : LAB_ID, &scene, WIDTH, HEIGHT);
        probe_knob(&probe, "map size", cascades ? CASCADE_MAP : ONE_MAP);
        if (cascades) {
            probe_knob(&probe, "slices", CASCADES);
            probe_knob(&probe, "lambda", 1);
            probe_knob(&probe, "blend", 0);
        }
        ok = ok && probe_draw(&probe);
        if (ok)
            add_rows(&probe, cascades ? cascade_texel : one_texel, bins);
        if (ok && i == 0)
            findings_frame(
                findings, cascades, 1, &probe.truth_view, &probe.measured,
                cascades
                    ? "The same by four maps of 128 x 128: the texels grow with the distance"
                    : "A long floor with one edge: the texels are as large everywhere, the pixels are not");
        probe_end(&probe);
    }
    for (int i = 0; ok && i < BINS; i++) {
        const Bin *bin = &bins[i];
        double expected = bin->expected / bin->rows, tolerance = tolerance_of(bin->texels, bin->expected);
        curve_add(curve, bin->depth / bin->rows, bin->wrong / bin->rows, expected, tolerance * expected);
    }
    return ok;
}

static bool run_perspective(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "An edge along a long floor",
                                     "distance from the camera (world units)", "error of the edge (pixels)");
    Curve *one = figure_curve(figure, "hard map", CURVE_EQUAL),
          *cascades = figure_curve(figure, "remedy: four cascades", CURVE_EQUAL);
    figure->log_x = figure->log_y = true;
    bool ok = sweep_floors(labs, findings, one, false) && sweep_floors(labs, findings, cascades, true);
    if (ok)
        add_slope(figure, one, "power law", -1);
    return ok;
}

// The shadow of a sphere on a wall and its outline, an ellipse with axes along those of the map, measured in
// a plane where all texels are alike.
typedef struct Disc {
    Scene scene;
    double half_side;     // of the map in that plane
    double stretch;       // area on the wall for one in that plane
    double length, error; // of the outline, and its mean error in texels, by direction
} Disc;

static void add_outline(Disc *disc, double a, double b) {
    enum { PARTS = 720 };
    double sum = 0;
    for (int i = 0; i < PARTS; i++) {
        double t = 2 * GLM_PI * i / PARTS, x = fabs(a * sin(t)), y = fabs(b * cos(t)), l = hypot(x, y);
        disc->length += l * 2 * GLM_PI / PARTS;
        sum += edge_error(x / l, y / l) * l * 2 * GLM_PI / PARTS;
    }
    disc->error = sum / disc->length;
}

// Light 45 degrees aslant, so that the sphere does not hide its shadow.
static Disc sun_disc(Random *random) {
    const float radius = 0.8F, half_size = 4;
    Disc disc = {.scene = closed_wall(6, 10, 2 * atanf(0.16F)), .half_side = half_size, .stretch = M_SQRT2};
    vec3s center = vec3_make(random_range(random, -2.6F, -2.4F), random_range(random, -0.1F, 0.1F), 2.5F);
    closed_add(&disc.scene, SHAPE_SPHERE, center, vec3_make(radius, radius, radius), 0);
    closed_light(&disc.scene, LIGHT_DIRECTIONAL, vec3_make(-6, 0, 6), vec3_make(0, 0, 0), 0, half_size, 1,
                 14);
    add_outline(&disc, radius, radius);
    return disc;
}

// A lamp that looks straight at the wall; the sphere is seen just beside its shadow. With sin a = r / d,
// theta the angle of the sphere's direction and Q = cos^2 theta - sin^2 a the half axes are H sin a cos a / Q
// and H sin a / sqrt Q.
static Disc lamp_disc(Random *random) {
    const float radius = 0.5F, height = 4, fov_y = glm_rad(104);
    Disc disc = {
        .scene = closed_wall(6, 10, 2 * atanf(0.18F)), .half_side = height * tan(0.5 * fov_y), .stretch = 1};
    const vec3s light = vec3_make(-3.85F, 0, height);
    vec3s center = vec3_make(random_range(random, -2.05F, -1.85F), random_range(random, -0.1F, 0.1F), 1.6F);
    closed_add(&disc.scene, SHAPE_SPHERE, center, vec3_make(radius, radius, radius), 0);
    closed_light(&disc.scene, LIGHT_SPOT, light, vec3_make(light.x, light.y, 0), fov_y, 0, 1, 8);
    double d = glms_vec3_distance(light, center), sine = radius / d, cosine = (height - center.z) / d;
    double q = cosine * cosine - sine * sine;
    add_outline(&disc, height * sine * sqrt(1 - sine * sine) / q, height * sine / sqrt(q));
    return disc;
}

// Adds the wrong area on the wall of each map size.
static bool add_sizes(Probe *probe, Findings *findings, int slot, double wrong[SIZES]) {
    double unit = probe_unit(probe);
    for (int i = 0; i < SIZES; i++) {
        probe_knob(probe, "map size", 128 << i);
        if (!probe_draw(probe))
            return false;
        double area = 0;
        for (int row = 0; row < probe->truth_view.size.height; row++)
            area += wrong_pixels(probe, row) * unit * unit;
        wrong[i] += area;
        findings_frame(findings, slot, area, &probe->truth_view, &probe->measured,
                       "A sphere's shadow, map of %d texels", 128 << i);
    }
    return true;
}

static bool sweep_sizes(LabSet *labs, Findings *findings, Curve *curve, Disc (*make)(Random *random),
                        int slot) {
    enum { SIDE = 400 };
    Random random = {SEED};
    Disc disc;
    double wrong[SIZES] = {0}, unit = 1;
    bool ok = true;
    for (int i = 0; ok && i < PLACES; i++) {
        Probe probe;
        disc = make(&random);
        ok = probe_begin(&probe, labs, LAB_ID, &disc.scene, SIDE, SIDE);
        probe.setting.object = 0; // the wall alone
        ok = ok && add_sizes(&probe, findings, slot, wrong);
        unit = ok ? probe_unit(&probe) : 1;
        probe_end(&probe);
    }
    for (int i = 0; ok && i < SIZES; i++) {
        double texel = 2 * disc.half_side / (128 << i), length = PLACES * disc.length,
               expected = disc.error * texel;
        double tolerance = tolerance_of(length / texel, expected * length * disc.stretch / (unit * unit));
        // One percent more: the mesh's outline has corners.
        curve_add(curve, 128 << i, wrong[i] / disc.stretch / length, expected, (0.01 + tolerance) * expected);
    }
    return ok;
}

static bool run_resolution(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "A disc's outline", "map size (texels)",
                                     "wrong area per length of the outline (world units)");
    Curve *sun = figure_curve(figure, "directional light", CURVE_EQUAL);
    Curve *lamp = figure_curve(figure, "spot light", CURVE_EQUAL);
    figure->log_x = figure->log_y = true;
    bool ok =
        sweep_sizes(labs, findings, sun, sun_disc, 0) && sweep_sizes(labs, findings, lamp, lamp_disc, 1);
    if (ok)
        add_slope(figure, sun, "power law", -1);
    return ok;
}

const Row LAB_TABLE[] = {
    {13, "perspective aliasing", "shadow map of 1024 x 1024, and four cascades of 128 x 128",
     "distance from the camera, along a long floor",
     "A texel covers the same part of the floor everywhere, a pixel one that grows with the distance: the "
     "edge's error in pixels goes as 1 / distance, so the map is too coarse nearby and wasted far away. The "
     "remedy, cascades (lab 15): texels grow with the slices, so the error stays between a best and a worst "
     "value, whatever the distance, with a sixteenth of the texels.",
     "closed form", run_perspective},
    {14, "resolution", "shadow map of both kinds of light", "map size, 128 to 2048 texels",
     "The wrong area per length of the edge is 0.2436 texels for a circle, the mean over all directions of "
     "the edge; for the "
     "ellipse of a lamp's shadow it is summed along the outline.",
     "closed form", run_resolution},
    {0},
};
