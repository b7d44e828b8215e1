#include "grade/attempt.h"

#include "scene/check.h"
#include "base/find_file.h"
#include "base/siphash.h"
#include "compile/lab_folder.h"

#include <stdlib.h>
#include <string.h>

static uint64_t add(uint64_t secret, uint64_t so_far, const char *text) {
    return siphash((const uint64_t[2]){secret, so_far}, text, strlen(text));
}

// A file that is missing or bad counts as one of no kind that can be handed in.
static uint64_t add_file(uint64_t secret, uint64_t so_far, const char *folder, const char *name) {
    char *text = find_file_read(folder, name, DERIVE_MAX_FILE);
    so_far = add(secret, so_far, text ? text : "\001");
    free(text);
    check_clear();
    return so_far;
}

uint64_t attempt_seed(uint64_t secret, const Submission *submission, const LabExam *examiners, int count) {
    uint64_t seed = add(secret, 0, "attempt");
    for (int i = 0; i < count; i++) {
        const Rubric *rubric = &examiners[i].rubric;
        char note[400];
        const char *folder = submission_find_of(submission, rubric->id, count, note, sizeof note);
        seed = add(secret, seed, rubric->id);
        for (int f = 0; folder && f < rubric->file_count; f++)
            seed = add_file(secret, seed, folder, rubric->files[f]);
    }
    return seed;
}
