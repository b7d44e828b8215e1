#include "window/compose.h"

#include "scene/check.h"
#include "score/score.h"

#include <math.h>
#include <string.h>

static const uint8_t missing[3] = {40, 40, 40};

static void ensure_size(Image *image, int width, int height) {
    if (image->rgba && image->width == width && image->height == height)
        return;
    image_destroy(image);
    bool created = image_create(image, width, height);
    INVARIANT(created);
}

int compose_column(float split, int width) {
    int column = (int)lrintf(split * (float)width);
    return column < 0 ? 0 : column > width ? width : column;
}

static bool fits(const Image *image, const Image *out) {
    return image->rgba && image->width == out->width && image->height == out->height;
}

// Copies the columns from `first` up to `end`, where the picture is there.
static void copy_columns(Image *out, const Image *from, int first, int end) {
    if (!fits(from, out) || first >= end)
        return;
    for (int y = 0; y < out->height; y++)
        memcpy(out->rgba + image_at(out, first, y), from->rgba + image_at(from, first, y),
               (size_t)(end - first) * 4);
}

// How many columns, from the left, show mine.
static int mine_columns(Show show, float split, int width) {
    return show == SHOW_SPLIT ? compose_column(split, width) : show == SHOW_MINE ? width : 0;
}

Difference compose(Image *out, Show show, const Image *mine, const Image *other, float split) {
    const Image *leading = show == SHOW_MINE || !other->rgba ? mine : other;
    if (!leading->rgba)
        return (Difference){0};
    ensure_size(out, leading->width, leading->height);
    if (show == SHOW_DIFFERENCE && fits(mine, out) && fits(other, out))
        return difference_mark(out, mine, other);
    score_fill(out, missing);
    int column = mine_columns(show, split, out->width);
    copy_columns(out, mine, 0, column);
    if (show != SHOW_DIFFERENCE)
        copy_columns(out, other, column, out->width);
    return (Difference){0};
}
