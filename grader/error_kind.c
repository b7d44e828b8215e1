#include "error_kind.h"

#include "check.h"
#include "score.h"

#include <math.h>
#include <string.h>

typedef struct Tally {
    double darker, lighter, other; // numbers of pixels
    double x, y;                   // sums over the wrong ones
} Tally;

static int brightness(const Image *image, size_t at) {
    return image->rgba[at] + image->rgba[at + 1] + image->rgba[at + 2];
}

static Tally tally(const Image *yours, const Image *reference) {
    Tally sum = {0};
    for (size_t at = 0; at < image_bytes(yours); at += 4) {
        if (score_pixel(yours, reference, at) == 0)
            continue;
        int difference = brightness(yours, at) - brightness(reference, at);
        *(difference < -6 ? &sum.darker : difference > 6 ? &sum.lighter : &sum.other) += 1;
        sum.x += (double)(at / 4 % (size_t)yours->width) + 0.5;
        size_t row = at / 4 / (size_t)yours->width;
        sum.y += (double)row + 0.5;
    }
    return sum;
}

bool error_kind_is_plain(const Image *image) {
    for (size_t at = 4; at < image_bytes(image); at += 4)
        if (memcmp(image->rgba, image->rgba + at, 3) != 0)
            return false;
    return true;
}

static bool is_upside_down(const Image *yours, const Image *reference) {
    size_t wrong = 0, row = (size_t)yours->width * 4;
    for (int y = 0; y < yours->height; y++)
        wrong += memcmp(yours->rgba + (size_t)y * row,
                        reference->rgba + (size_t)(yours->height - 1 - y) * row, row) != 0;
    return wrong <= (size_t)yours->height / 20;
}

static const char *place(double x, double y) {
    static const char *const names[3][3] = {{"upper left", "top", "upper right"},
                                            {"left", "middle", "right"},
                                            {"lower left", "bottom", "lower right"}};
    return names[(int)fmin(y * 3, 2)][(int)fmin(x * 3, 2)];
}

void error_kind(char *text, size_t size, const Image *yours, const Image *reference) {
    Tally sum = tally(yours, reference);
    double wrong = sum.darker + sum.lighter + sum.other, pixels = (double)yours->width * yours->height;
    text[0] = '\0';
    if (error_kind_is_plain(yours)) {
        check_append(text, size, "nothing drawn: the whole picture has one colour");
        return;
    }
    if (is_upside_down(yours, reference)) {
        check_append(text, size, "upside down");
        return;
    }
    const char *kind = sum.darker > 3 * (sum.lighter + sum.other)   ? "false shadow: too dark"
                       : sum.lighter > 3 * (sum.darker + sum.other) ? "false light: too bright"
                                                                    : "wrong colour";
    double share = wrong > 0 ? wrong : 1;
    check_append(text, size, "%s in %.0f %% of the picture, mostly at the %s", kind,
                 fmax(100 * wrong / pixels, 1),
                 place(sum.x / share / yours->width, sum.y / share / yours->height));
}
