#include "window/counts.h"

#include "scene/count.h"

#include <stdlib.h>
#include <string.h>

// Counts that are right go from dark to bright; below 0, where only mistakes lead, is red to violet.
static const CountColor colors[] = {
    {"0", {0, 0, 0}, {38, 42, 50}},
    {"1", {64, 64, 64}, {52, 120, 220}},
    {"2", {128, 128, 128}, {40, 170, 140}},
    {"3", {191, 191, 191}, {235, 190, 60}},
    {"4 and more", {255, 255, 255}, {255, 255, 255}},
    {"-1", {255, 0, 0}, {225, 50, 50}},
    {"-2", {255, 64, 0}, {235, 70, 160}},
    {"-3", {255, 128, 0}, {165, 70, 215}},
    {"-4", {255, 191, 0}, {110, 40, 120}},
};

enum { TOLERANCE = 3 }; // of a channel: drivers round

bool counts_is_view(const char *view) {
    return strcmp(view, "stencil counts") == 0;
}

const CountColor *counts_color(int i) {
    return i < (int)COUNT(colors) ? &colors[i] : NULL;
}

const CountColor *counts_find(const uint8_t rgb[3]) {
    for (unsigned i = 0; i < COUNT(colors); i++) {
        const uint8_t *stage = colors[i].stage;
        if (abs(rgb[0] - stage[0]) <= TOLERANCE && abs(rgb[1] - stage[1]) <= TOLERANCE &&
            abs(rgb[2] - stage[2]) <= TOLERANCE)
            return &colors[i];
    }
    return NULL;
}

void counts_recolor(Image *picture) {
    for (size_t at = 0; picture->rgba && at < image_bytes(picture); at += 4) {
        const CountColor *count = counts_find(picture->rgba + at);
        if (count)
            memcpy(picture->rgba + at, count->shown, 3);
    }
}
