#include "stability/strip.h"

#include "scene/check.h"

#include <math.h>
#include <string.h>

enum { PARTS = 3, GAP = 4, LEAST_HEIGHT = 40, WIDE = 3 };

static uint8_t grey(float visibility) {
    return (uint8_t)(visibility * 255 + 0.5f);
}

// The colours of the three parts at one pixel of the frame.
static void find_colors(uint8_t colors[PARTS][4], float measured, float truth, bool counts) {
    static const float light[3] = {255, 208, 32}, shadow[3] = {48, 112, 255};
    float seen = isfinite(measured) ? measured : 0, off = seen - truth, base = 40 + 30 * truth;
    for (int c = 0; c < 3; c++) {
        float color = off > 0 ? light[c] : shadow[c];
        colors[0][c] = grey(seen);
        colors[1][c] = grey(truth);
        colors[2][c] = counts ? (uint8_t)(base + fabsf(off) * (color - base)) : 0;
    }
    colors[0][3] = colors[1][3] = colors[2][3] = 255;
}

bool strip_create(Image *strip, const TruthView *truth_view, const Measured *measured) {
    int width = truth_view->size.width, height = truth_view->size.height;
    bool stacked = width > WIDE * height;
    int times = stacked ? (LEAST_HEIGHT + height - 1) / height : 1;
    int right = stacked ? 0 : width + GAP, down = stacked ? times * height + GAP : 0;
    if (!image_create(strip, width + (PARTS - 1) * right + 2 * GAP,
                      times * height + (PARTS - 1) * down + 2 * GAP))
        return false;
    memset(strip->rgba, 128, image_bytes(strip));
    for (int y = 0; y < times * height; y++)
        for (int x = 0; x < width; x++) {
            size_t from = (size_t)(y / times) * (size_t)width + (size_t)x;
            uint8_t colors[PARTS][4];
            find_colors(colors, measured->visibility[from], truth_view->visibility[from],
                        measured->mask[from]);
            for (int i = 0; i < PARTS; i++)
                memcpy(strip->rgba + image_at(strip, GAP + x + i * right, GAP + y + i * down), colors[i], 4);
        }
    return true;
}
