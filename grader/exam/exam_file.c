// Writes an exam as JSON and strips of frames, one PNG a check, and reads it back: same requests, same
// pictures.
#include "exam/exam_file.h"

#include "scene/check.h"
#include "exam/exam_matrix.h"
#include "exam/exam_reset.h"
#include "exam/exam_facts.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// A check's frames lie one below the other in one PNG: of each variant the reference, and then what differs
// from it, as the exclusive or with the reference, which is mostly 0. Other frames refer to theirs by its
// distance from the reference, 0 for the reference itself.
enum { MAX_FRAMES = EXAM_MAX_MISTAKES + EXAM_MAX_TASKS + RUBRIC_MAX_ALSO + EXAM_MAX_PARTS + 3 };

static void place(char path[FILES_PATH], const char *folder, uint64_t seed, const char *end) {
    char name[64];
    snprintf(name, sizeof name, "exam-%llu%s", (unsigned long long)seed, end);
    files_join(path, folder, name);
}

static void place_strip(char path[FILES_PATH], const char *folder, uint64_t seed, int c) {
    char end[24];
    snprintf(end, sizeof end, "-%02d.png", c + 1);
    place(path, folder, seed, end);
}

typedef struct Strip {
    const Image *frames[EXAM_MAX_VARIANTS * MAX_FRAMES]; // not owned
    int bases[EXAM_MAX_VARIANTS * MAX_FRAMES];           // number of the reference
    int count, base;
} Strip;

// The distance of the frame from its reference; adds it when it is not there yet.
static int put(Strip *strip, const Image *frame) {
    for (int i = strip->base; i < strip->count; i++)
        if (memcmp(strip->frames[i]->rgba, frame->rgba, image_bytes(frame)) == 0)
            return i - strip->base;
    strip->frames[strip->count] = frame;
    strip->bases[strip->count] = strip->base;
    return strip->count++ - strip->base;
}

static json_t *put_mistakes(Strip *strip, Exam *exam, int c, int n) {
    json_t *list = json_array();
    for (int m = 0; m < exam->rubric->mistake_count; m++) {
        const Image *frame = exam_mistake(exam, m, c, n);
        if (frame)
            json_array_append_new(list, json_integer(put(strip, frame)));
    }
    return list;
}

typedef const Image *LateOf(Exam *exam, int i, int c, int n);

// -1: ours drew none, because there is no such task, or what is as it was handed out does not fit the rest.
static json_t *put_late(Strip *strip, Exam *exam, LateOf *late, int count, int c, int n) {
    json_t *list = json_array();
    for (int i = 0; i < count; i++) {
        const Image *frame = late(exam, i, c, n);
        json_array_append_new(list, json_integer(frame ? put(strip, frame) : -1));
    }
    return list;
}

static json_t *put_variant(Strip *strip, Exam *exam, int c, int n) {
    const Variant *variant = &exam->variants[c][n];
    strip->base = strip->count;
    put(strip, &variant->reference);
    int without = put(strip, &variant->without), skeleton = put(strip, &variant->skeleton);
    const Parts *parts = exam_parts(exam);
    json_t *mistakes = put_mistakes(strip, exam, c, n),
           *partials = put_late(strip, exam, exam_partial, EXAM_MAX_TASKS, c, n),
           *also = put_late(strip, exam, exam_also, exam->rubric->also_count, c, n),
           *resets = put_late(strip, exam, exam_reset, parts ? parts->count : 0, c, n);
    return json_pack("{s:i, s:i, s:i, s:i, s:o, s:o, s:o, s:o, s:o}", "try", exam->tries[c][n], "frame",
                     strip->base, "without", without, "skeleton", skeleton, "mistakes", mistakes, "partials",
                     partials, "also", also, "resets", resets, "facts", exam_facts_pack(exam, c, n));
}

static bool write_strip(const Strip *strip, const char *path) {
    Image all;
    const Image *first = strip->frames[0];
    size_t bytes = image_bytes(first), size;
    if (!image_create(&all, first->width, first->height * strip->count))
        return false;
    for (int i = 0; i < strip->count; i++) {
        const Image *base = strip->bases[i] == i ? NULL : strip->frames[strip->bases[i]];
        for (size_t at = 0; at < bytes; at++)
            all.rgba[(size_t)i * bytes + at] = strip->frames[i]->rgba[at] ^ (base ? base->rgba[at] : 0);
    }
    uint8_t *png = image_encode_png(&all, true, &size);
    image_destroy(&all);
    FILE *file = png ? fopen(path, "wb") : NULL;
    bool ok = file && fwrite(png, 1, size, file) == size;
    ok = file && fclose(file) == 0 && ok;
    free(png);
    return ok || check_fail("%s cannot be written", path);
}

// What is not recorded for want of a worker would look like a picture that there is none of.
static bool is_whole(const Exam *exam, const json_t *entry) {
    if (exam->painters && painters_lost(exam->painters)) {
        check_clear(); // whatever was asked for last
        return check_fail("the exam %llu of lab %s is not whole: the process that draws it has ended (was it "
                          "killed?): record it again",
                          (unsigned long long)exam->seed, exam->rubric->id);
    }
    return json_array_size(json_object_get(entry, "mistakes")) == (size_t)exam->rubric->mistake_count ||
           check_fail(
               "the exam %llu of lab %s lacks the picture of a mistake: look with build/prove --lab %s",
               (unsigned long long)exam->seed, exam->rubric->id, exam->rubric->id);
}

static bool save_check(Exam *exam, int c, const char *folder, json_t *checks) {
    static Strip strip;
    char path[FILES_PATH];
    strip.count = 0;
    json_t *variants = json_array();
    json_array_append_new(checks, variants);
    bool ok = true;
    for (int n = 0; ok && n < exam->rubric->checks[c].variants; n++) {
        json_t *entry = put_variant(&strip, exam, c, n);
        ok = json_array_append_new(variants, entry) == 0 && is_whole(exam, entry);
    }
    place_strip(path, folder, exam->seed, c);
    return ok && write_strip(&strip, path);
}

bool exam_file_save(Exam *exam, const char *folder) {
    char path[FILES_PATH];
    json_t *checks = json_array();
    json_t *root =
        json_pack("{s:i, s:s, s:o, s:o, s:o}", "version", 3, "renderer", exam->renderer, "checks", checks,
                  "without_task", exam_matrix_pack(exam), "hidden", exam_hidden_pack(exam));
    bool ok = true;
    for (int c = 0; ok && c < exam->rubric->check_count; c++)
        ok = save_check(exam, c, folder, checks);
    place(path, folder, exam->seed, ".json");
    if (ok && json_dump_file(root, path, JSON_COMPACT) != 0)
        ok = check_fail("%s cannot be written", path);
    json_decref(root);
    return ok;
}

// Cuts a frame out of the strip. False when there is no such frame.
static bool cut(Image *image, const Image *strip, const Request *request, int base, int distance) {
    size_t bytes = 4 * (size_t)request->width * (size_t)request->height;
    int frames = (int)(image_bytes(strip) / bytes);
    if (base < 0 || distance < 0 || strip->width != request->width || base >= frames - distance ||
        !image_create(image, request->width, request->height))
        return false;
    const uint8_t *first = strip->rgba + (size_t)base * bytes, *from = first + (size_t)distance * bytes;
    for (size_t at = 0; at < bytes; at++)
        image->rgba[at] = from[at] ^ (distance ? first[at] : 0);
    return true;
}

typedef struct Cutting {
    const Image *strip;
    const Request *request;
    int base;
} Cutting;

static bool cut_late(LatePicture *late, const Cutting *cutting, json_t *list, int i) {
    const json_t *entry = json_array_get(list, (size_t)i);
    int distance = json_is_integer(entry) ? (int)json_integer_value(entry) : -1;
    late->known = distance >= 0;
    return distance <= 0 || cut(&late->image, cutting->strip, cutting->request, cutting->base, distance);
}

static bool load_variant(Exam *exam, int c, int n, const Image *strip, json_t *entry) {
    Variant *variant = &exam->variants[c][n];
    int base, without, skeleton;
    json_t *mistakes, *partials, *also, *resets, *facts;
    if (json_unpack(entry, "{s:i, s:i, s:i, s:o, s:o, s:o, s:o, s:o}", "frame", &base, "without", &without,
                    "skeleton", &skeleton, "mistakes", &mistakes, "partials", &partials, "also", &also,
                    "resets", &resets, "facts", &facts) != 0 ||
        json_array_size(mistakes) != (size_t)exam->rubric->mistake_count)
        return false;
    const Cutting cutting = {strip, &variant->request, base};
    bool ok = cut(&variant->reference, strip, &variant->request, base, 0) &&
              cut(&variant->without, strip, &variant->request, base, without) &&
              cut(&variant->skeleton, strip, &variant->request, base, skeleton);
    for (int m = 0; ok && m < exam->rubric->mistake_count; m++)
        ok = cut_late(&exam->mistakes[m][c][n], &cutting, mistakes, m);
    for (int t = 0; ok && t < EXAM_MAX_TASKS; t++)
        ok = cut_late(&exam->partials[t][c][n], &cutting, partials, t);
    for (int a = 0; ok && a < exam->rubric->also_count; a++)
        ok = cut_late(&exam->also[a][c][n], &cutting, also, a);
    for (int p = 0; ok && p < EXAM_MAX_PARTS; p++)
        ok = cut_late(&exam->resets[p][c][n], &cutting, resets, p);
    exam_facts_unpack(exam, c, n, facts);
    return ok;
}

static bool load_check(Exam *exam, int c, json_t *variants) {
    char path[FILES_PATH];
    Image strip = {0};
    place_strip(path, exam->rubric->folder, exam->seed, c);
    bool ok = image_read_png(&strip, path);
    for (int n = 0; ok && n < exam->rubric->checks[c].variants; n++)
        ok = load_variant(exam, c, n, &strip, json_array_get(variants, (size_t)n));
    image_destroy(&strip);
    return ok;
}

static bool restore(Exam *exam, const Rubric *rubric, uint64_t seed, json_t *checks) {
    static int tries[RUBRIC_MAX_CHECKS][EXAM_MAX_VARIANTS];
    for (int c = 0; c < rubric->check_count; c++)
        for (int n = 0; n < rubric->checks[c].variants; n++)
            tries[c][n] = (int)json_integer_value(
                json_object_get(json_array_get(json_array_get(checks, (size_t)c), (size_t)n), "try"));
    return exam_restore(exam, rubric, seed, tries);
}

bool exam_file_load(Exam *exam, const Rubric *rubric, uint64_t seed) {
    char path[FILES_PATH];
    place(path, rubric->folder, seed, ".json");
    json_t *root = json_load_file(path, 0, NULL), *checks = json_object_get(root, "checks");
    const char *renderer = json_string_value(json_object_get(root, "renderer"));
    if (!root)
        return check_fail("seed %llu is not recorded here: take one of those in grader/recorded/seeds.json",
                          (unsigned long long)seed);
    bool ok = renderer && json_array_size(checks) == (size_t)rubric->check_count &&
              restore(exam, rubric, seed, checks) &&
              exam_matrix_unpack(exam, json_object_get(root, "without_task")) &&
              exam_hidden_unpack(exam, json_object_get(root, "hidden"));
    for (int c = 0; ok && c < rubric->check_count; c++)
        ok = load_check(exam, c, json_array_get(checks, (size_t)c));
    if (ok)
        snprintf(exam->renderer, sizeof exam->renderer, "%s", renderer);
    else
        exam_destroy(exam);
    json_decref(root);
    return ok || check_fail("%s and its pictures do not fit the rubric", path);
}

static bool load_reference(const Exam *exam, int c, int n, const json_t *checks, Variant *variant) {
    char path[FILES_PATH];
    Image strip = {0};
    const json_t *entry = json_array_get(json_array_get(checks, (size_t)c), (size_t)n);
    const int base = (int)json_integer_value(json_object_get(entry, "frame"));
    image_destroy(&variant->reference);
    *variant = exam->variants[c][n];
    place_strip(path, exam->rubric->folder, exam->seed, c);
    const bool ok =
        image_read_png(&strip, path) && cut(&variant->reference, &strip, &variant->request, base, 0);
    image_destroy(&strip);
    return ok;
}

bool exam_file_reference(const Rubric *rubric, uint64_t seed, int c, int n, Variant *variant) {
    char path[FILES_PATH];
    place(path, rubric->folder, seed, ".json");
    json_t *root = json_load_file(path, 0, NULL), *checks = json_object_get(root, "checks");
    Exam *exam = calloc(1, sizeof *exam);
    const bool ok = exam && json_array_size(checks) == (size_t)rubric->check_count &&
                    restore(exam, rubric, seed, checks) && load_reference(exam, c, n, checks, variant);
    free(exam);
    json_decref(root);
    return ok || check_fail("%s and its pictures are not whole: unpack the kit again", path);
}
