// Pictures in memory and as PNG. No GL.
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// Row 0 is the top row. Alpha is 255, or 0 where the renderer produced a colour that is not a finite number.
typedef struct Image {
    int width, height;
    uint8_t *rgba; // width * height * 4 bytes, owned
} Image;

// Black, with alpha 0. False when there is no memory.
bool image_create(Image *image, int width, int height);
void image_destroy(Image *image); // accepts a zeroed image

// Number of bytes of the pixels.
size_t image_bytes(const Image *image);

// Offset of the pixel in column x of row y in rgba, bytes.
size_t image_at(const Image *image, int x, int y);

// Same size and content copied. `copy` must be zeroed or an image that may be freed.
bool image_copy(Image *copy, const Image *image);

// A smaller picture, whose pixels are the means of squares of `times` x `times` pixels (of fewer at the right
// and lower border). The caller destroys it. False when there is no memory.
bool image_shrink(Image *small, const Image *image, int times);

// 8-bit RGB PNG; alpha is dropped.
bool image_write_png(const Image *image, const char *path);
// The same in memory, `size` bytes, smaller, and with alpha when asked for; freed by the
// caller. NULL with a message.
uint8_t *image_encode_png(const Image *image, bool alpha, size_t *size);
bool image_read_png(Image *image, const char *path);
