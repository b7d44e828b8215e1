#include "score/difference.h"

#include "score/score.h"

#include <string.h>

enum { COLOR_ONLY = 6 }; // of the sum of three channels: a change of brightness is larger

static int brightness(const uint8_t *pixel) {
    return pixel[0] + pixel[1] + pixel[2];
}

static void paint(uint8_t *to, int color) {
    for (int i = 0; i < 3; i++)
        to[i] = (uint8_t)(color >> (16 - 8 * i));
}

static void mark_pixel(uint8_t *to, int change, Difference *difference) {
    if (change > COLOR_ONLY) {
        paint(to, DIFFERENCE_BRIGHTER);
        difference->brighter++;
    } else if (change < -COLOR_ONLY) {
        paint(to, DIFFERENCE_DARKER);
        difference->darker++;
    } else {
        paint(to, DIFFERENCE_OTHER);
        difference->other++;
    }
}

Difference difference_mark(Image *picture, const Image *yours, const Image *reference) {
    Difference difference = {0};
    for (size_t at = 0; at < image_bytes(yours); at += 4) {
        int is = brightness(yours->rgba + at), wanted = brightness(reference->rgba + at);
        uint8_t *to = picture->rgba + at;
        memset(to, 40 + wanted / 12, 3);
        to[3] = 255;
        if (score_pixel(yours, reference, at) > 0)
            mark_pixel(to, is - wanted, &difference);
    }
    return difference;
}
