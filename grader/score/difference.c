#include "score/difference.h"

#include "score/score.h"

#include <string.h>

enum { COLOR_ONLY = 6 }; // of the sum of three channels: a change of brightness is larger

static const uint8_t brighter[3] = {255, 208, 32}, darker[3] = {48, 112, 255}, other[3] = {255, 48, 255};

static int brightness(const uint8_t *pixel) {
    return pixel[0] + pixel[1] + pixel[2];
}

static void mark_pixel(uint8_t *to, int change, Difference *difference) {
    if (change > COLOR_ONLY) {
        memcpy(to, brighter, 3);
        difference->brighter++;
    } else if (change < -COLOR_ONLY) {
        memcpy(to, darker, 3);
        difference->darker++;
    } else {
        memcpy(to, other, 3);
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
