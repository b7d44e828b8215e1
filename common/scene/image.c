#include "scene/image.h"

#include "scene/check.h"

#include <png.h>
#include <stdlib.h>
#include <string.h>

bool image_create(Image *image, int width, int height) {
    *image = (Image){.width = width, .height = height, .rgba = calloc((size_t)width * (size_t)height, 4)};
    return image->rgba || check_fail("out of memory for a picture of %d x %d", width, height);
}

void image_destroy(Image *image) {
    free(image->rgba);
    *image = (Image){0};
}

size_t image_bytes(const Image *image) {
    return (size_t)image->width * (size_t)image->height * 4;
}

size_t image_at(const Image *image, int x, int y) {
    return 4 * ((size_t)y * (size_t)image->width + (size_t)x);
}

bool image_copy(Image *copy, const Image *image) {
    INVARIANT(copy != image);
    Image made;
    if (!image_create(&made, image->width, image->height))
        return false;
    memcpy(made.rgba, image->rgba, image_bytes(image));
    image_destroy(copy);
    *copy = made;
    return true;
}

// The mean of the pixels of `image` that pixel x, y of the smaller picture covers, one channel.
static uint8_t mean(const Image *image, int x, int y, int times, int channel) {
    int sum = 0, count = 0;
    for (int v = y * times; v < (y + 1) * times && v < image->height; v++)
        for (int u = x * times; u < (x + 1) * times && u < image->width; u++, count++)
            sum += image->rgba[image_at(image, u, v) + (size_t)channel];
    return count > 0 ? (uint8_t)((sum + count / 2) / count) : 0;
}

bool image_shrink(Image *small, const Image *image, int times) {
    if (!image_create(small, (image->width + times - 1) / times, (image->height + times - 1) / times))
        return false;
    for (int y = 0; y < small->height; y++)
        for (int x = 0; x < small->width; x++)
            for (int channel = 0; channel < 4; channel++)
                small->rgba[image_at(small, x, y) + (size_t)channel] = mean(image, x, y, times, channel);
    return true;
}

static uint8_t *rgb_of(const Image *image) {
    size_t pixels = image_bytes(image) / 4;
    uint8_t *rgb = malloc(pixels * 3);
    for (size_t i = 0; rgb && i < pixels; i++)
        memcpy(rgb + 3 * i, image->rgba + 4 * i, 3);
    return rgb;
}

static png_image rgb_header(const Image *image) {
    return (png_image){.version = PNG_IMAGE_VERSION,
                       .width = (png_uint_32)image->width,
                       .height = (png_uint_32)image->height,
                       .format = PNG_FORMAT_RGB,
                       .flags = PNG_IMAGE_FLAG_FAST};
}

bool image_write_png(const Image *image, const char *path) {
    png_image png = rgb_header(image);
    uint8_t *rgb = rgb_of(image);
    bool ok = rgb && png_image_write_to_file(&png, path, 0, rgb, 0, NULL);
    free(rgb);
    return ok || check_fail("%s: cannot write the picture: %s", path, rgb ? png.message : "out of memory");
}

uint8_t *image_encode_png(const Image *image, bool alpha, size_t *size) {
    png_image png = rgb_header(image);
    png.flags = 0;
    png.format = alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    uint8_t *rgb = alpha ? NULL : rgb_of(image), *bytes = NULL;
    png_alloc_size_t room = PNG_IMAGE_PNG_SIZE_MAX(png);
    bool ok = (alpha || rgb) && (bytes = malloc(room)) &&
              png_image_write_to_memory(&png, bytes, &room, 0, alpha ? image->rgba : rgb, 0, NULL);
    free(rgb);
    *size = room;
    if (ok)
        return bytes;
    free(bytes);
    check_fail("cannot encode a picture: %s", png.message);
    return NULL;
}

bool image_read_png(Image *image, const char *path) {
    png_image png = {.version = PNG_IMAGE_VERSION};
    if (!png_image_begin_read_from_file(&png, path))
        return check_fail("%s: cannot read the picture: %s", path, png.message);
    png.format = PNG_FORMAT_RGBA;
    if (!image_create(image, (int)png.width, (int)png.height)) {
        png_image_free(&png);
        return false;
    }
    if (png_image_finish_read(&png, NULL, image->rgba, 0, NULL))
        return true;
    image_destroy(image);
    return check_fail("%s: cannot read the picture: %s", path, png.message);
}
