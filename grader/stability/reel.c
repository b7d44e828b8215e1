#include "stability/reel.h"

#include <stdio.h>
#include <stdlib.h>

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
    if (image_shrink(&small, strip, (strip->width + REEL_WIDTH - 1) / REEL_WIDTH))
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
