#include "report/evidence_files.h"

#include "base/files.h"

#include <ctype.h>
#include <stdio.h>

static void slug(char *to, size_t size, const char *name) {
    size_t length = 0;
    for (; *name && length < size - 1; name++)
        to[length++] = isalnum((unsigned char)*name) ? (char)tolower((unsigned char)*name) : '-';
    to[length] = '\0';
}

static bool write_check(const CheckResult *check, const char *folder) {
    static const char *const kinds[] = {"yours", "reference", "difference", "crop"};
    char path[FILES_PATH], name[100], file[128];
    bool ok = true;
    slug(name, sizeof name, check->check->name);
    for (int i = 0; ok && i < EVIDENCE_PARTS; i++) {
        snprintf(file, sizeof file, "%s-%s.png", name, kinds[i]);
        files_join(path, folder, file);
        ok = image_write_png(&check->evidence[i], path);
    }
    return ok;
}

bool evidence_write(const LabResult *result, const char *folder) {
    char lab_folder[FILES_PATH];
    bool ok = true;
    files_join(lab_folder, folder, result->id);
    for (int c = 0; ok && c < result->check_count; c++)
        if (result->checks[c].evidence[0].rgba)
            ok = files_make_folder(lab_folder) && write_check(&result->checks[c], lab_folder);
    return ok;
}
