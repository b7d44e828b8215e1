#include "report.h"

#include "check.h"
#include "difference.h"
#include "files.h"
#include "score.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { CROP = 48, ENLARGED = 4 };

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

static void slug(char *to, size_t size, const char *name) {
    size_t length = 0;
    for (; *name && length < size - 1; name++)
        to[length++] = isalnum((unsigned char)*name) ? (char)tolower((unsigned char)*name) : '-';
    to[length] = '\0';
}

static bool write_one(const Image *image, const char *folder, const char *check, const char *kind) {
    char path[FILES_PATH], name[FILES_PATH];
    snprintf(name, sizeof name, "%s-%s.png", check, kind);
    files_join(path, folder, name);
    return image_write_png(image, path);
}

bool report_evidence(const LabResult *result, const Exam *exam, const char *folder) {
    char lab_folder[FILES_PATH], name[100];
    bool ok = true;
    files_join(lab_folder, folder, result->id);
    check_append(lab_folder, sizeof lab_folder, "/");
    for (int c = 0; ok && c < result->check_count; c++) {
        const CheckResult *check = &result->checks[c];
        const Image *yours = &check->yours[check->worst],
                    *reference = &exam->variants[c][check->worst].reference;
        if (check->passed || !yours->rgba)
            continue;
        Image difference = {0}, crop = {0};
        slug(name, sizeof name, check->check->name);
        ok = files_make_folder(lab_folder) && image_copy(&difference, yours);
        if (ok)
            difference_mark(&difference, yours, reference);
        ok = ok && make_crop(&crop, (const Image *const[3]){yours, reference, &difference}) &&
             write_one(&crop, lab_folder, name, "crop") && write_one(yours, lab_folder, name, "yours") &&
             write_one(reference, lab_folder, name, "reference") &&
             write_one(&difference, lab_folder, name, "difference");
        image_destroy(&difference);
        image_destroy(&crop);
    }
    return ok;
}
