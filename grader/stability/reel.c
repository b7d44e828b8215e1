#include "stability/reel.h"

#include <stdio.h>
#include <stdlib.h>

// The mean of the pixels of `image` that pixel x, y of the smaller picture covers, one channel.
static uint8_t mean(const Image *image, int x, int y, int times, int channel) {
    int sum = 0, count = 0;
    for (int v = y * times; v < (y + 1) * times && v < image->height; v++)
        for (int u = x * times; u < (x + 1) * times && u < image->width; u++, count++)
            sum += image->rgba[image_at(image, u, v) + (size_t)channel];
    return count > 0 ? (uint8_t)((sum + count / 2) / count) : 0;
}

bool reel_shrink(Image *small, const Image *image, int width) {
    const int times = (image->width + width - 1) / width;
    if (!image_create(small, (image->width + times - 1) / times, (image->height + times - 1) / times))
        return false;
    for (int y = 0; y < small->height; y++)
        for (int x = 0; x < small->width; x++)
            for (int channel = 0; channel < 4; channel++)
                small->rgba[image_at(small, x, y) + (size_t)channel] = mean(image, x, y, times, channel);
    return true;
}

// Keeps every second frame.
static void thin_out(Reel *reel) {
    for (int i = 0; i < reel->count; i++)
        if (i % 2 == 0)
            reel->frames[i / 2] = reel->frames[i];
        else
            free(reel->frames[i].png);
    reel->count = (reel->count + 1) / 2;
    reel->stride *= 2;
}

void reel_add(Reel *reel, const Image *strip, const char *caption) {
    Image small = {0};
    if (reel->stride == 0)
        reel->stride = 1;
    if (reel->seen++ % reel->stride != 0)
        return;
    if (reel->count == REEL_MOST)
        thin_out(reel);
    if ((reel->seen - 1) % reel->stride != 0)
        return;
    ReelFrame *frame = &reel->frames[reel->count];
    *frame = (ReelFrame){0};
    if (reel_shrink(&small, strip, REEL_WIDTH))
        frame->png = image_encode_png(&small, false, &frame->size);
    image_destroy(&small);
    snprintf(frame->caption, sizeof frame->caption, "%s", caption);
    reel->count += frame->png != NULL;
}

void reel_destroy(Reel *reel) {
    for (int i = 0; i < reel->count; i++)
        free(reel->frames[i].png);
    *reel = (Reel){0};
}
