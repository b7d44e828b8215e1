#include "class/origin.h"

#include "base/hash.h"
#include "base/places.h"
#include "scene/check.h"

#include <stdio.h>
#include <string.h>

enum { DIGITS = 17 };

// The handout and its pictures decide over no grade.
static bool decides(const char *name) {
    const char *dot = strrchr(name, '.');
    return strcmp(name, "README.md") != 0 && strcmp(name, "pictures") != 0 &&
           (!dot || strcmp(dot, ".png") != 0);
}

static uint64_t hash_grader(void) {
    static const char *const parts[] = {"common", "shaders"}, *const programs[] = {"grade", "worker"};
    char path[FILES_PATH];
    uint64_t hash = HASH_START;
    for (int i = 0; i < 2; i++) {
        places_path(path, parts[i]);
        hash = hand_in_hash_folder(hash, path, decides, NULL);
    }
    for (int i = 0; i < 2; i++) {
        places_build_path(path, programs[i]);
        hash = hand_in_hash_file(hash, path);
    }
    return hash;
}

bool origin_read(Origin *origin, const RunSettings *plan) {
    char path[FILES_PATH];
    *origin = (Origin){.grader = hash_grader()};
    for (int n = 0; n < plan->lab_count; n++) {
        if (!places_find_lab(path, plan->labs[n]))
            return check_fail("there is no lab %s in solutions/", plan->labs[n]);
        origin->rubrics[n] = hand_in_hash_folder(HASH_START, path, decides, NULL);
    }
    return true;
}

static void write_hash(char text[DIGITS], uint64_t hash) {
    snprintf(text, DIGITS, "%016llx", (unsigned long long)hash);
}

json_t *origin_json(const Origin *origin, const RunSettings *plan, uint64_t submission) {
    char text[2][DIGITS], rubric[DIGITS];
    json_t *rubrics = json_object();
    for (int n = 0; n < plan->lab_count; n++) {
        write_hash(rubric, origin->rubrics[n]);
        json_object_set_new(rubrics, plan->labs[n], json_string(rubric));
    }
    write_hash(text[0], submission);
    write_hash(text[1], origin->grader);
    return json_pack("{s:s, s:s, s:o}", "submission", text[0], "grader", text[1], "rubrics", rubrics);
}

static bool is(const json_t *kept, uint64_t hash) {
    char text[DIGITS];
    write_hash(text, hash);
    return json_is_string(kept) && strcmp(json_string_value(kept), text) == 0;
}

void origin_differs(char why[ORIGIN_TEXT], const json_t *record, const Origin *origin,
                    const RunSettings *plan, const uint64_t *submission) {
    const json_t *kept = json_object_get(record, "made_of"), *rubrics = json_object_get(kept, "rubrics");
    why[0] = '\0';
    if (submission && !is(json_object_get(kept, "submission"), *submission))
        snprintf(why, ORIGIN_TEXT, "another submission");
    for (int n = 0; !why[0] && n < plan->lab_count; n++)
        if (!is(json_object_get(rubrics, plan->labs[n]), origin->rubrics[n]))
            snprintf(why, ORIGIN_TEXT, "another rubric of lab %s", plan->labs[n]);
    if (!why[0] && !is(json_object_get(kept, "grader"), origin->grader))
        snprintf(why, ORIGIN_TEXT, ORIGIN_GRADER);
}
