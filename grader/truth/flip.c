// Filters both pictures as the eye does, and combines the difference of colours with that of edges and
// points.
#include "truth/flip.h"

#include "scene/check.h"
#include "scene/mathx.h"
#include "truth/separable.h"

#include <math.h>
#include <stdlib.h>

#define PIXELS_PER_DEGREE (3840 * GLM_PI / 180) // distance and width of the screen are the same
#define FEATURE_WIDTH 0.082                     // degrees
enum { COLOR_RADIUS = 10, FEATURE_RADIUS = 9 }; // three standard deviations of the widest filter, rounded up

// sRGB's primaries and white (IEC 61966-2-1), column by column.
static const mat3s xyz_from_rgb = {{{0.4123908f, 0.2126390f, 0.0193308f},
                                    {0.3575843f, 0.7151687f, 0.1191948f},
                                    {0.1804808f, 0.0721923f, 0.9505322f}}};

// X, Y and Z of (1, 1, 1).
static vec3s white(void) {
    return glms_mat3_mulv(xyz_from_rgb, vec3_make(1, 1, 1));
}

// A linear cousin of L*a*b*: Y, Cx, Cz.
static vec3s opponent_from_rgb(vec3s rgb) {
    vec3s xyz = glms_vec3_div(glms_mat3_mulv(xyz_from_rgb, rgb), white());
    return vec3_make(116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z));
}

static vec3s rgb_from_opponent(vec3s opponent, mat3s rgb_from_xyz) {
    float y = (opponent.x + 16) / 116;
    vec3s xyz = vec3_make(y + opponent.y / 500, y, y - opponent.z / 200);
    return glms_mat3_mulv(rgb_from_xyz, glms_vec3_mul(xyz, white()));
}

static float lab_curve(float t) {
    const float knee = 6.0f / 29;
    return t > knee * knee * knee ? cbrtf(t) : t / (3 * knee * knee) + 4.0f / 29;
}

// L*a*b*, with colours the weaker, the darker they are (Hunt).
static vec3s lab_from_rgb(vec3s rgb) {
    vec3s xyz = glms_vec3_div(glms_mat3_mulv(xyz_from_rgb, rgb), white());
    float x = lab_curve(xyz.x), y = lab_curve(xyz.y), z = lab_curve(xyz.z), lightness = 116 * y - 16;
    return vec3_make(lightness, 0.01f * lightness * 500 * (x - y), 0.01f * lightness * 200 * (y - z));
}

// HyAB's distance, compressed.
static float color_distance(vec3s a, vec3s b) {
    return powf(fabsf(a.x - b.x) + hypotf(a.y - b.y, a.z - b.z), 0.7f);
}

// A Gaussian of the eye's sensitivity to contrast: exp(-pi^2 x^2 / b), x in degrees; not normalised.
static SeparableKernel contrast_kernel(double b) {
    SeparableKernel kernel = {.radius = COLOR_RADIUS};
    for (int i = -COLOR_RADIUS; i <= COLOR_RADIUS; i++) {
        double x = i / PIXELS_PER_DEGREE;
        kernel.weights[i + COLOR_RADIUS] = (float)exp(-GLM_PI * GLM_PI * x * x / b);
    }
    return kernel;
}

static double total(const SeparableKernel *kernel) {
    double sum = 0;
    for (int i = 0; i <= 2 * kernel->radius; i++)
        sum += kernel->weights[i];
    return sum;
}

typedef struct Sensitivity {
    double b, share; // width, and the weight of its Gaussian
} Sensitivity;

// Filters a plane by a sum of Gaussians; `scratch` holds two planes.
static void filter_channel(MetricsSize size, float *plane, const Sensitivity *parts, int count,
                           float *scratch) {
    size_t pixels = (size_t)size.width * (size_t)size.height;
    float *sum = scratch, *filtered = scratch + pixels;
    double weight = 0;
    for (size_t i = 0; i < pixels; i++)
        sum[i] = 0;
    for (int p = 0; p < count; p++) {
        SeparableKernel kernel = contrast_kernel(parts[p].b);
        double share = parts[p].share * sqrt(GLM_PI / parts[p].b);
        weight += share * total(&kernel) * total(&kernel);
        separable_filter(size, plane, &kernel, &kernel, filtered);
        for (size_t i = 0; i < pixels; i++)
            sum[i] += (float)share * filtered[i];
    }
    for (size_t i = 0; i < pixels; i++)
        plane[i] = sum[i] / (float)weight;
}

// `planes`: Y, Cx and Cz, one after the other, then two for scratch. A plane that is 0 everywhere stays so.
static void filter_colors(MetricsSize size, float *planes, bool is_grey) {
    static const Sensitivity luminance = {0.0047, 1}, red_green = {0.0053, 1},
                             blue_yellow[2] = {{0.04, 34.1}, {0.025, 13.5}};
    size_t pixels = (size_t)size.width * (size_t)size.height;
    filter_channel(size, planes, &luminance, 1, planes + 3 * pixels);
    if (is_grey)
        return;
    filter_channel(size, planes + pixels, &red_green, 1, planes + 3 * pixels);
    filter_channel(size, planes + 2 * pixels, blue_yellow, 2, planes + 3 * pixels);
}

// A Gaussian (order 0) or its first or second derivative; what is positive sums up to 1, what is negative to
// -1.
static SeparableKernel feature_kernel(int order) {
    const double sigma = 0.5 * FEATURE_WIDTH * PIXELS_PER_DEGREE;
    SeparableKernel kernel = {.radius = FEATURE_RADIUS};
    double positive = 0, negative = 0;
    for (int i = -FEATURE_RADIUS; i <= FEATURE_RADIUS; i++) {
        double x = i / sigma, factor = order == 0 ? 1 : order == 1 ? -x : x * x - 1;
        double weight = factor * exp(-x * x / 2);
        kernel.weights[i + FEATURE_RADIUS] = (float)weight;
        positive += fmax(weight, 0);
        negative += fmax(-weight, 0);
    }
    for (int i = 0; i <= 2 * FEATURE_RADIUS; i++)
        kernel.weights[i] /= (float)(kernel.weights[i] > 0 ? positive : negative > 0 ? negative : 1);
    return kernel;
}

// Strength of the derivative of this order along x and y together.
static void find_features(MetricsSize size, const float *lightness, int order, float *strength,
                          float *scratch) {
    size_t pixels = (size_t)size.width * (size_t)size.height;
    SeparableKernel derivative = feature_kernel(order), smooth = feature_kernel(0);
    separable_filter(size, lightness, &derivative, &smooth, strength);
    separable_filter(size, lightness, &smooth, &derivative, scratch);
    for (size_t i = 0; i < pixels; i++)
        strength[i] = hypotf(strength[i], scratch[i]);
}

static bool allocate(FlipPicture *picture, MetricsSize size, float **planes) {
    size_t pixels = (size_t)size.width * (size_t)size.height;
    *picture = (FlipPicture){.size = size,
                             .color = malloc(3 * pixels * sizeof(float)),
                             .edge = malloc(pixels * sizeof(float)),
                             .point = malloc(pixels * sizeof(float))};
    *planes = malloc(5 * pixels * sizeof(float));
    return (picture->color && picture->edge && picture->point && *planes) ||
           check_fail("out of memory to compare %d x %d pixels", size.width, size.height);
}

static vec3s clamped(vec3s rgb) {
    return glms_vec3_clamp(rgb, 0, 1);
}

static void see(FlipPicture *picture, float *planes, bool is_grey) {
    size_t pixels = (size_t)picture->size.width * (size_t)picture->size.height;
    float *scratch = planes + 3 * pixels;
    mat3s rgb_from_xyz = glms_mat3_inv(xyz_from_rgb);
    for (size_t i = 0; i < pixels; i++)
        scratch[i] = (planes[i] + 16) / 116;
    find_features(picture->size, scratch, 1, picture->edge, scratch + pixels);
    find_features(picture->size, scratch, 2, picture->point, scratch + pixels);
    filter_colors(picture->size, planes, is_grey);
    for (size_t i = 0; i < pixels; i++) {
        vec3s seen = vec3_make(planes[i], planes[pixels + i], planes[2 * pixels + i]);
        vec3s color = lab_from_rgb(clamped(rgb_from_opponent(seen, rgb_from_xyz)));
        for (size_t c = 0; c < 3; c++)
            picture->color[3 * i + c] = color.raw[c];
    }
}

bool flip_create(FlipPicture *picture, MetricsSize size, const float *rgb) {
    size_t pixels = (size_t)size.width * (size_t)size.height;
    float *planes;
    bool ok = allocate(picture, size, &planes), is_grey = true;
    for (size_t i = 0; ok && i < pixels; i++) {
        vec3s color = clamped(vec3_make(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]));
        vec3s opponent = opponent_from_rgb(color);
        bool is_same = color.x == color.y && color.y == color.z;
        is_grey = is_grey && is_same;
        for (size_t c = 0; c < 3; c++)
            planes[c * pixels + i] = c > 0 && is_same ? 0 : opponent.raw[c];
    }
    if (ok)
        see(picture, planes, is_grey);
    free(planes);
    return ok;
}

bool flip_create_grey(FlipPicture *picture, MetricsSize size, const float *grey) {
    size_t pixels = (size_t)size.width * (size_t)size.height;
    float *rgb = calloc(3 * pixels, sizeof *rgb);
    for (size_t i = 0; rgb && i < 3 * pixels; i++)
        rgb[i] = grey[i / 3];
    *picture = (FlipPicture){0};
    bool ok = rgb ? flip_create(picture, size, rgb) : check_fail("out of memory for a grey picture");
    free(rgb);
    return ok;
}

void flip_destroy(FlipPicture *picture) {
    free(picture->color);
    free(picture->edge);
    free(picture->point);
    *picture = (FlipPicture){0};
}

// The largest distance that sRGB has, between its green and its blue.
static float largest_distance(void) {
    return color_distance(lab_from_rgb(vec3_make(0, 1, 0)), lab_from_rgb(vec3_make(0, 0, 1)));
}

// Small distances get most of the range 0..1.
static float spread(float distance) {
    const float most = largest_distance(), knee = 0.4f * most, at_knee = 0.95f;
    return distance < knee ? distance * at_knee / knee
                           : at_knee + (distance - knee) / (most - knee) * (1 - at_knee);
}

float flip_at(const FlipPicture *reference, const FlipPicture *test, size_t i) {
    const float *a = reference->color + 3 * i, *b = test->color + 3 * i;
    float color = spread(color_distance(vec3_make(a[0], a[1], a[2]), vec3_make(b[0], b[1], b[2])));
    float edge = fabsf(reference->edge[i] - test->edge[i]),
          point = fabsf(reference->point[i] - test->point[i]);
    float feature = sqrtf(fmaxf(edge, point) / (float)GLM_SQRT2);
    return color > 0 ? powf(color, 1 - feature) : 0;
}

double flip_mean(const FlipPicture *reference, const FlipPicture *test, const uint8_t *mask) {
    size_t pixels = (size_t)reference->size.width * (size_t)reference->size.height, count = 0;
    double sum = 0;
    for (size_t i = 0; i < pixels; i++)
        if (!mask || mask[i]) {
            sum += (double)flip_at(reference, test, i);
            count++;
        }
    return count ? sum / (double)count : 0;
}
