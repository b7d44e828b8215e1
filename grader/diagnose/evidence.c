#include "diagnose/evidence.h"

#include "scene/check.h"
#include "score/score.h"

#include <string.h>

enum { CROP = 48, ENLARGED = 4, SHRUNK = 3 };

// The upper left corner of the CROP x CROP part with the most wrong pixels.
static void find_crop(const Image *yours, const Image *reference, int *left, int *top) {
    size_t most = 0;
    for (int y = 0; y + CROP <= yours->height; y += CROP / 4)
        for (int x = 0; x + CROP <= yours->width; x += CROP / 4) {
            size_t wrong = 0;
            for (int v = y; v < y + CROP; v++)
                for (int u = x; u < x + CROP; u++)
                    wrong += score_pixel(yours, reference, image_at(yours, u, v)) > 0;
            if (wrong > most) {
                most = wrong;
                *left = x;
                *top = y;
            }
        }
}

// Yours, reference and difference side by side, enlarged, where most is wrong.
static bool make_crop(Image *crop, const Image *const parts[3]) {
    int left = 0, top = 0;
    find_crop(parts[0], parts[1], &left, &top);
    if (!image_create(crop, 3 * CROP * ENLARGED, CROP * ENLARGED))
        return false;
    for (int y = 0; y < crop->height; y++)
        for (int x = 0; x < crop->width; x++) {
            const Image *part = parts[x / (CROP * ENLARGED)];
            int u = left + x % (CROP * ENLARGED) / ENLARGED, v = top + y / ENLARGED;
            bool inside = u < part->width && v < part->height;
            if (inside)
                memcpy(crop->rgba + image_at(crop, x, y), part->rgba + image_at(part, u, v), 4);
        }
    return true;
}

// A third of each side, each pixel the mean of nine: enough to see what is wrong, too little to be handed in.
static bool shrink(Image *image) {
    Image small = {0};
    if (!image_create(&small, image->width / SHRUNK, image->height / SHRUNK))
        return false;
    for (size_t at = 0; at < image_bytes(&small); at++) {
        const int x = (int)(at / 4) % small.width, y = (int)(at / 4) / small.width;
        int sum = 0;
        for (int i = 0; i < SHRUNK * SHRUNK; i++)
            sum += image->rgba[image_at(image, SHRUNK * x + i % SHRUNK, SHRUNK * y + i / SHRUNK) + at % 4];
        small.rgba[at] = (uint8_t)(sum / (SHRUNK * SHRUNK));
    }
    image_destroy(image);
    *image = small;
    return true;
}

static bool attach(CheckResult *check, const Image *yours, const Image *reference, bool hidden) {
    Image *parts = check->evidence;
    if (!image_copy(&parts[EVIDENCE_YOURS], yours) || !image_copy(&parts[EVIDENCE_REFERENCE], reference) ||
        !image_copy(&parts[EVIDENCE_DIFFERENCE], yours))
        return false;
    check->difference = difference_mark(&parts[EVIDENCE_DIFFERENCE], yours, reference);
    return make_crop(&parts[EVIDENCE_CROP], (const Image *const[3]){&parts[0], &parts[1], &parts[2]}) &&
           (!hidden || (shrink(&parts[EVIDENCE_YOURS]) && shrink(&parts[EVIDENCE_REFERENCE]) &&
                        shrink(&parts[EVIDENCE_DIFFERENCE])));
}

bool evidence_attach(LabResult *result, const Exam *exam, bool hidden) {
    bool ok = true;
    for (int c = 0; ok && c < result->check_count; c++) {
        CheckResult *check = &result->checks[c];
        const Image *yours = &check->yours[check->worst];
        if (!check->passed && yours->rgba)
            ok = attach(check, yours, &exam->variants[c][check->worst].reference, hidden);
    }
    return ok;
}
