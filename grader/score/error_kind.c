// Tries kinds in turn, from nothing drawn over shifts and edges to colours, and names the first that fits.
#include "score/error_kind.h"

#include "scene/check.h"
#include "score/score.h"
#include "score/soft_kind.h"
#include "score/whole_kind.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_SHIFT = 12, EDGE = 2 };

// What a kind explains: at most this share of the wrong pixels may be left over.
static const double REST = 0.2;

typedef struct Tally {
    double darker, lighter, other;    // numbers of wrong pixels
    double at_edges;                  // of them within EDGE pixels of an edge of the reference
    double x, y;                      // mean place of the wrong ones, 0..1
    double dark_change, light_change; // mean change of brightness in the reference's darker and lighter half
} Tally;

static int brightness(const Image *image, size_t at) {
    return image->rgba[at] + image->rgba[at + 1] + image->rgba[at + 2];
}

static bool near_edge(const Image *image, int x, int y) {
    int low = 765, high = 0;
    for (int v = y - EDGE; v <= y + EDGE; v++)
        for (int u = x - EDGE; u <= x + EDGE; u++) {
            if (u < 0 || v < 0 || u >= image->width || v >= image->height)
                continue;
            int value = brightness(image, image_at(image, u, v));
            low = value < low ? value : low;
            high = value > high ? value : high;
        }
    return high - low > 60;
}

static int middle_brightness(const Image *image) {
    int low = 765, high = 0;
    for (size_t at = 0, end = image_bytes(image); at < end; at += 4) {
        low = brightness(image, at) < low ? brightness(image, at) : low;
        high = brightness(image, at) > high ? brightness(image, at) : high;
    }
    return (low + high) / 2;
}

static Tally tally(const Image *yours, const Image *reference) {
    Tally sum = {0};
    double dark = 0, light = 0;
    int middle = middle_brightness(reference);
    for (int y = 0; y < yours->height; y++)
        for (int x = 0; x < yours->width; x++) {
            size_t at = image_at(yours, x, y);
            if (score_pixel(yours, reference, at) == 0)
                continue;
            int change = brightness(yours, at) - brightness(reference, at);
            bool in_dark = brightness(reference, at) < middle;
            *(change < -6 ? &sum.darker : change > 6 ? &sum.lighter : &sum.other) += 1;
            *(in_dark ? &sum.dark_change : &sum.light_change) += change;
            *(in_dark ? &dark : &light) += 1;
            sum.at_edges += near_edge(reference, x, y);
            sum.x += (x + 0.5) / yours->width;
            sum.y += (y + 0.5) / yours->height;
        }
    double wrong = fmax(dark + light, 1);
    sum.x /= wrong;
    sum.y /= wrong;
    sum.dark_change /= fmax(dark, 1);
    sum.light_change /= fmax(light, 1);
    return sum;
}

bool error_kind_is_plain(const Image *image) {
    for (size_t at = 4; at < image_bytes(image); at += 4)
        if (memcmp(image->rgba, image->rgba + at, 3) != 0)
            return false;
    return true;
}

// Wrong pixels of yours moved by (dx, dy), optionally upside down, over the part that both pictures cover,
// scaled to the whole picture.
static double wrong_when_moved(const Image *yours, const Image *reference, int dx, int dy, bool flip) {
    double wrong = 0, count = 0;
    for (int y = abs(dy); y < yours->height - abs(dy); y++)
        for (int x = abs(dx); x < yours->width - abs(dx); x++) {
            int row = flip ? yours->height - 1 - y : y + dy;
            const uint8_t *a = yours->rgba + image_at(yours, x + dx, row);
            const uint8_t *b = reference->rgba + image_at(reference, x, y);
            wrong += abs(a[0] - b[0]) + abs(a[1] - b[1]) + abs(a[2] - b[2]) > 3 * SCORE_TOLERANCE;
            count++;
        }
    return wrong / fmax(count, 1) * yours->width * yours->height;
}

static bool find_shift(const Image *yours, const Image *reference, double wrong, int *dx, int *dy) {
    double best = REST * wrong;
    bool found = false;
    for (int v = -MAX_SHIFT; v <= MAX_SHIFT; v++)
        for (int u = -MAX_SHIFT; u <= MAX_SHIFT; u++) {
            double left = u || v ? wrong_when_moved(yours, reference, u, v, false) : wrong;
            if (left < best) {
                best = left;
                *dx = u;
                *dy = v;
                found = true;
            }
        }
    return found;
}

static double dark_pixels(const Image *image, int limit) {
    double count = 0;
    for (size_t at = 0, end = image_bytes(image); at < end; at += 4)
        count += brightness(image, at) < limit;
    return count;
}

static const char *place(double x, double y) {
    static const char *const names[3][3] = {{"upper left", "top", "upper right"},
                                            {"left", "middle", "right"},
                                            {"lower left", "bottom", "lower right"}};
    return names[(int)fmin(y * 3, 2)][(int)fmin(x * 3, 2)];
}

// Kinds that only say how the picture as a whole lies.
static const char *moved_kind(char *text, size_t size, const Image *yours, const Image *reference,
                              double wrong) {
    int dx = 0, dy = 0;
    if (wrong_when_moved(yours, reference, 0, 0, true) < REST * wrong) {
        check_append(text, size, "upside down");
        return "upside down";
    }
    if (!find_shift(yours, reference, wrong, &dx, &dy))
        return NULL;
    check_append(text, size, "shifted: right, but %d pixels to the %s and %d %s", abs(dx),
                 dx > 0 ? "right" : "left", abs(dy), dy > 0 ? "down" : "up");
    return "shifted";
}

// Errors of one sign that leave the shape and change its size: the shadow grows or shrinks by some part of
// itself.
static bool is_resized(char *text, size_t size, const Image *yours, const Image *reference,
                       const Tally *sum) {
    int middle = middle_brightness(reference);
    double mine = dark_pixels(yours, middle), right = fmax(dark_pixels(reference, middle), 1);
    double wrong = sum->darker + sum->lighter, ratio = mine / right;
    bool one_sign =
        fmin(sum->darker, sum->lighter)<REST * wrong, explained = fabs(mine - right)>(1 - REST) * wrong;
    if (!one_sign || !explained || ratio < 0.3 || ratio > 3 || mine == 0 || fabs(ratio - 1) < 0.1)
        return false;
    check_append(text, size, "wrong size: the dark part has %.1f times its area", ratio);
    return true;
}

// What is wrong with the shadows, by the share of the wrong pixels that have one sign.
static const char *shadow_kind(const Tally *sum, double wrong, double pixels, ErrorView view) {
    if (sum->at_edges > (1 - REST / 2) * wrong && wrong < pixels / 8)
        return "edges only: right but for the edges";
    if (view == ERROR_VIEW_SHADED && wrong > pixels / 3 &&
        fabs(sum->dark_change) > fabs(sum->light_change) / 2)
        return sum->dark_change > 0 ? "ambient term: the shadows are too bright, too"
                                    : "ambient term: the shadows are too dark, too";
    if (sum->darker > (1 - REST) * wrong)
        return "false shadow: too dark where light should be";
    if (sum->lighter > (1 - REST) * wrong)
        return "false light: too bright where shadow should be";
    if (fmin(sum->darker, sum->lighter) > REST * wrong)
        return "offset, or wider or narrower: the shadow is not where it should be";
    return "another colour";
}

// The same where there are no shadows.
static const char *value_kind(const Tally *sum, double wrong, double pixels) {
    if (sum->at_edges > (1 - REST / 2) * wrong && wrong < pixels / 8)
        return "edges only: right but for the edges";
    if (sum->darker > (1 - REST) * wrong)
        return "too dark";
    if (sum->lighter > (1 - REST) * wrong)
        return "too bright";
    if (sum->other > (1 - REST) * wrong)
        return "another colour";
    return "another picture: partly too dark, partly too bright";
}

// "; 12 % of the picture (9 % too dark, 3 % too bright), mostly at the left": without what is 0.
static void add_amounts(char *text, size_t size, const Tally *sum, double wrong, double pixels) {
    const double dark = 100 * sum->darker / pixels, bright = 100 * sum->lighter / pixels;
    check_append(text, size, "; %.0f %% of the picture", fmax(100 * wrong / pixels, 1));
    if (dark >= 1 && bright >= 1)
        check_append(text, size, " (%.0f %% too dark, %.0f %% too bright)", dark, bright);
    check_append(text, size, ", mostly at the %s", place(sum->x, sum->y));
}

const char *error_kind(char *text, size_t size, const Image *yours, const Image *reference, ErrorView view) {
    Tally sum = tally(yours, reference);
    double wrong = fmax(sum.darker + sum.lighter + sum.other, 1),
           pixels = (double)yours->width * yours->height;
    text[0] = '\0';
    if (error_kind_is_plain(yours)) {
        check_append(text, size, "nothing drawn: the whole picture has one colour");
        return "nothing drawn: the whole picture has one colour";
    }
    const char *moved = moved_kind(text, size, yours, reference, wrong);
    if (moved)
        return moved;
    const char *kind = whole_kind(yours, reference, wrong);
    kind = kind ? kind : soft_kind(yours, reference, view != ERROR_VIEW_VALUES);
    kind = kind ? kind : average_kind(yours, reference);
    if (!kind && view != ERROR_VIEW_VALUES) // samples at other places are no edges
        kind = coarse_kind(yours, reference);
    if (kind) {
        check_append(text, size, "%s", kind);
        return kind;
    }
    kind =
        view == ERROR_VIEW_VALUES ? value_kind(&sum, wrong, pixels) : shadow_kind(&sum, wrong, pixels, view);
    char resized[100] = "";
    check_append(text, size, "%s", kind);
    if (view != ERROR_VIEW_VALUES && is_resized(resized, sizeof resized, yours, reference, &sum))
        check_append(text, size, "; %s", resized);
    add_amounts(text, size, &sum, wrong, pixels);
    return kind;
}
