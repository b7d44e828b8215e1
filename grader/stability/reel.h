// The frames of a row's sweep in their order, small, for who wants to see a method break.
#pragma once

#include "scene/image.h"

#include <stdint.h>

enum { REEL_MOST = 48, REEL_TEXT = 160, REEL_WIDTH = 330 };

typedef struct ReelFrame {
    char caption[REEL_TEXT];
    uint8_t *png; // owned
    size_t size;
} ReelFrame;

// Of a longer sweep every second frame is kept, every fourth, and so on.
typedef struct Reel {
    ReelFrame frames[REEL_MOST];
    int count, seen, stride;
} Reel;

// Adds the picture (strip.h), no wider than REEL_WIDTH pixels. Without memory it is left out: the verdict
// does not depend on it.
void reel_add(Reel *reel, const Image *strip, const char *caption);
void reel_destroy(Reel *reel); // accepts a zeroed reel
