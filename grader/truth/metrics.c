// Which pixels count, where the shadow's edge is and how wide, and the sums of false shadow and false light
// in both parts.
#include "truth/metrics.h"

#include "scene/check.h"

#include <math.h>
#include <stdlib.h>

enum { TRIANGLES = 0x10000 };

int32_t metrics_primitive(int object, int triangle) {
    if (object < 0)
        return METRICS_NO_PRIMITIVE;
    INVARIANT(object < 0x8000 && triangle >= 0 && triangle < TRIANGLES);
    return object * TRIANGLES + triangle;
}

int32_t metrics_decode_primitive(const uint8_t rgba[4]) {
    return metrics_primitive(rgba[0] - 1, rgba[1] + 256 * rgba[2]);
}

int metrics_object(int32_t primitive) {
    return primitive < 0 ? -1 : primitive / TRIANGLES;
}

static bool is_silhouette(MetricsSize size, const int32_t *traced, int x, int y) {
    int object = metrics_object(traced[(ptrdiff_t)y * size.width + x]);
    for (int v = y - 1; v <= y + 1; v++)
        for (int u = x - 1; u <= x + 1; u++)
            if (u >= 0 && v >= 0 && u < size.width && v < size.height &&
                metrics_object(traced[(ptrdiff_t)v * size.width + u]) != object)
                return true;
    return false;
}

size_t metrics_mask(MetricsSize size, const MetricsPixels *pixels, uint8_t *mask) {
    size_t count = 0;
    for (int y = 0; y < size.height; y++)
        for (int x = 0; x < size.width; x++) {
            ptrdiff_t i = (ptrdiff_t)y * size.width + x;
            mask[i] = pixels->traced[i] >= 0 && pixels->drawn[i] == pixels->traced[i] &&
                      pixels->facing[i] > METRICS_LEAST_FACING && isfinite(pixels->measured[i]) &&
                      !is_silhouette(size, pixels->traced, x, y);
            count += mask[i];
        }
    return count;
}

// Squared distances to the nearest sample of a line: the lower envelope of the parabolas value[q] + (x -
// q)^2. `line` has `count` values `stride` apart; hull and from are scratch of count and count + 1 entries.
static void transform_line(float *line, ptrdiff_t stride, int count, int *hull, double *from, double *value) {
    int top = -1;
    for (int q = 0; q < count; q++) {
        value[q] = line[q * stride];
        if (isinf(value[q]))
            continue;
        double meet = -INFINITY;
        while (top >= 0) {
            int p = hull[top];
            meet = (value[q] + (double)q * q - value[p] - (double)p * p) / (2.0 * (q - p));
            if (meet > from[top])
                break;
            top--;
        }
        hull[++top] = q;
        from[top] = top ? meet : -INFINITY;
    }
    for (int x = 0, k = 0; x < count && top >= 0; x++) {
        while (k < top && from[k + 1] < x)
            k++;
        double away = x - hull[k];
        line[x * stride] = (float)(value[hull[k]] + away * away);
    }
}

static bool transform(MetricsSize size, float *squares) {
    size_t longest = (size_t)(size.width > size.height ? size.width : size.height);
    int *hull = calloc(longest, sizeof *hull);
    double *from = calloc(longest, sizeof *from), *value = calloc(longest, sizeof *value);
    bool ok = hull && from && value;
    for (int x = 0; ok && x < size.width; x++)
        transform_line(squares + x, size.width, size.height, hull, from, value);
    for (int y = 0; ok && y < size.height; y++)
        transform_line(squares + (ptrdiff_t)y * size.width, 1, size.width, hull, from, value);
    free(hull);
    free(from);
    free(value);
    return ok || check_fail("out of memory for the distances of %d x %d pixels", size.width, size.height);
}

// Marks both pixels where the boundary runs between i and j.
static void mark_boundary(const int32_t *traced, const float *truth, ptrdiff_t i, ptrdiff_t j,
                          float *squares) {
    if (traced[i] >= 0 && metrics_object(traced[i]) == metrics_object(traced[j]) &&
        (truth[i] < 0.5f) != (truth[j] < 0.5f))
        squares[i] = squares[j] = 0;
}

bool metrics_boundary(MetricsSize size, const int32_t *traced, const float *truth, float *distance) {
    ptrdiff_t count = (ptrdiff_t)size.width * size.height;
    for (ptrdiff_t i = 0; i < count; i++)
        distance[i] = INFINITY;
    for (ptrdiff_t i = 0; i < count; i++) {
        if (i % size.width + 1 < size.width)
            mark_boundary(traced, truth, i, i + 1, distance);
        if (i + size.width < count)
            mark_boundary(traced, truth, i, i + size.width, distance);
    }
    if (!transform(size, distance))
        return false;
    for (ptrdiff_t i = 0; i < count; i++)
        distance[i] = sqrtf(distance[i]) + 0.5f;
    return true;
}

float metrics_edge_width(float kernel, float texel) {
    return fmaxf(METRICS_LEAST_EDGE, kernel + texel);
}

static void add_pixel(MetricsPart *part, double error) {
    part->false_shadow += fmax(-error, 0);
    part->false_light += fmax(error, 0);
    part->rmse += error * error;
    part->pixels++;
}

static void finish_part(MetricsPart *part, size_t mask_pixels) {
    double count = mask_pixels ? (double)mask_pixels : 1;
    part->false_shadow /= count;
    part->false_light /= count;
    part->rmse = sqrt(part->rmse / count);
    part->mae = part->false_light + part->false_shadow;
    part->bias = part->false_light - part->false_shadow;
}

Metrics metrics_compare(MetricsSize size, const uint8_t *mask, const float *measured, const float *truth,
                        const float *distance, float edge_width) {
    Metrics metrics = {0};
    for (ptrdiff_t i = 0; i < (ptrdiff_t)size.width * size.height; i++) {
        if (!mask[i])
            continue;
        double error = (double)measured[i] - truth[i];
        add_pixel(&metrics.all, error);
        add_pixel(distance[i] <= edge_width ? &metrics.edge : &metrics.interior, error);
    }
    size_t pixels = metrics.all.pixels;
    finish_part(&metrics.edge, pixels);
    finish_part(&metrics.interior, pixels);
    finish_part(&metrics.all, pixels);
    return metrics;
}
