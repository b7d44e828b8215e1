#include "report.h"

#include "check.h"
#include "files.h"
#include "score.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

// The reference in dim grey; too bright in yellow, too dark in blue, another colour in magenta.
static void mark_difference(Image *difference, const Image *yours, const Image *reference) {
    static const uint8_t brighter[3] = {255, 208, 32}, darker[3] = {48, 112, 255}, other[3] = {255, 48, 255};
    for (size_t at = 0; at < image_bytes(yours); at += 4) {
        const uint8_t *a = yours->rgba + at, *b = reference->rgba + at;
        int change = a[0] + a[1] + a[2] - b[0] - b[1] - b[2];
        uint8_t grey = (uint8_t)(40 + (b[0] + b[1] + b[2]) / 12);
        uint8_t *to = difference->rgba + at;
        memset(to, grey, 3);
        to[3] = 255;
        if (score_pixel(yours, reference, at) > 0)
            memcpy(to, change > 6 ? brighter : change < -6 ? darker : other, 3);
    }
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
        Image difference = {0};
        slug(name, sizeof name, check->check->name);
        ok = files_make_folder(lab_folder) && image_copy(&difference, yours);
        if (ok)
            mark_difference(&difference, yours, reference);
        ok = ok && write_one(yours, lab_folder, name, "yours") &&
             write_one(reference, lab_folder, name, "reference") &&
             write_one(&difference, lab_folder, name, "difference");
        image_destroy(&difference);
    }
    return ok;
}
