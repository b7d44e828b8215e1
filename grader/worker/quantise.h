// From the floats of a picture to the bytes that are sent.
#pragma once

#include <stdint.h>

// `colors` has four floats a pixel, the lowest row first, `pixels` four bytes, the top row first; both belong
// to the caller. Clamped to 0..1; a pixel with a NaN or an infinity becomes black with alpha 0.
void quantise(const float *colors, uint8_t *pixels, int width, int height);
