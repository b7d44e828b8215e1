// Moves camera and light, traces each view once and keeps it, and compares frames with it.
#include "study/views.h"

#include "base/hash.h"
#include "scene/check.h"
#include "study/edge.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Move {
    float turn, height, distance; // of the camera: degrees about the vertical, factors
    float light_turn;             // degrees
    vec2s light_shift;            // along the light's map, in its half size (or half width at the target)
} Move;

// Shifts are no whole number of texels in a map of any size.
static const Move moves[STUDY_VIEWS] = {
    {0, 1, 1, 0, {{0, 0}}},
    {12, 1, 1.1f, -8, {{0.0037f, 0.0061f}}},
    {-12, 1, 0.9f, 8, {{-0.0053f, 0.0023f}}},
    {6, 1.15f, 0.9f, -4, {{0.0071f, -0.0019f}}},
    {-6, 0.85f, 1.1f, 4, {{-0.0011f, -0.0067f}}},
    {9, 0.85f, 1, 6, {{0.0029f, 0.0047f}}},
};

static vec3s turned(vec3s offset, float degrees) {
    return glms_vec3_rotate(offset, glm_rad(degrees), vec3_make(0, 1, 0));
}

static void move_camera(Camera *camera, const Move *move) {
    vec3s offset = turned(glms_vec3_sub(camera->eye, camera->target), move->turn);
    offset.y *= move->height;
    camera->eye = glms_vec3_add(camera->target, glms_vec3_scale(offset, move->distance));
}

static void move_light(Light *light, const Move *move) {
    vec3s right, up, offset = turned(glms_vec3_sub(light->position, light->target), move->light_turn);
    float half =
        light->kind == LIGHT_DIRECTIONAL ? light->half_size : glms_vec3_norm(offset) * tanf(light->fov_y / 2);
    light->position = glms_vec3_add(light->target, offset);
    light_axes(light, &right, &up);
    vec3s shift = glms_vec3_add(glms_vec3_scale(right, half * move->light_shift.x),
                                glms_vec3_scale(up, half * move->light_shift.y));
    light->position = glms_vec3_add(light->position, shift);
    light->target = glms_vec3_add(light->target, shift);
}

static void make_moved(const StudyScene *scene, const Move *move, Scene *made) {
    scene->make(made);
    move_camera(&made->camera, move);
    for (int i = 0; i < made->light_count; i++)
        move_light(&made->lights[i], move);
    study_settle(made, scene);
}

void views_make(const StudyScene *scene, int view, Scene *made) {
    INVARIANT(view >= 0 && view < STUDY_VIEWS);
    if (view == 0)
        scene->make(made);
    else
        make_moved(scene, &moves[view], made);
}

void views_make_drawn(const StudyScene *scene, Random *random, Scene *made) {
    Move move;
    move.turn = random_range(random, -12, 12);
    move.height = random_range(random, 0.85f, 1.15f);
    move.distance = random_range(random, 0.9f, 1.1f);
    move.light_turn = random_range(random, -8, 8);
    move.light_shift.x = random_range(random, -0.0075f, 0.0075f);
    move.light_shift.y = random_range(random, -0.0075f, 0.0075f);
    make_moved(scene, &move, made);
}

// A truth's place, named after all that it was made from.
static void truth_path(char path[FILES_PATH], const char *folder, const TruthView *truth_view,
                       const TruthQuery *query) {
    enum { VERSION = 2 };
    const int32_t numbers[] = {
        VERSION,        STUDY_ACROSS,     truth_view->size.width, truth_view->size.height,
        query->samples, (int)query->kind, (int32_t)query->seed,   query->light};
    uint64_t hash = hash_bytes(HASH_START, numbers, sizeof numbers);
    hash = hash_bytes(hash, &query->area, sizeof query->area);
    hash = hash_bytes(hash, &query->limit, sizeof query->limit);
    hash = hash_bytes(hash, &truth_view->truth.scene, sizeof truth_view->truth.scene);
    char name[48];
    snprintf(name, sizeof name, "truth/%016" PRIx64, hash);
    files_join(path, folder, name);
}

// A name of the truth's content, which ends its file: a file of the right size may still hold other bytes, as
// after a crash or from a failing disk.
static uint64_t content_of(const float *visibility, const float *noise, size_t pixels) {
    uint64_t hash = hash_bytes(HASH_START, visibility, pixels * sizeof *visibility);
    return hash_bytes(hash, noise, pixels * sizeof *noise);
}

static float *read_floats(FILE *file, size_t count) {
    float *floats = malloc(count * sizeof *floats);
    if (floats && fread(floats, sizeof *floats, count, file) == count)
        return floats;
    free(floats);
    return NULL;
}

// A truth of an earlier run; false, without a message, when there is none that is whole.
static bool recall(TruthView *truth_view, const char *path) {
    size_t pixels = (size_t)truth_view->size.width * (size_t)truth_view->size.height;
    uint64_t content = 0;
    FILE *file = fopen(path, "rb");
    if (!file)
        return false;
    float *visibility = read_floats(file, pixels), *noise = visibility ? read_floats(file, pixels) : NULL;
    bool whole = noise && fread(&content, sizeof content, 1, file) == 1 &&
                 content == content_of(visibility, noise, pixels);
    fclose(file);
    if (whole)
        return truth_view_take(truth_view, visibility, noise);
    free(visibility);
    free(noise);
    return false;
}

// Keeps the truth for the next run. A disk that is full costs time, not the study: half a truth is not taken.
static void keep(const TruthView *truth_view, const char *path) {
    size_t pixels = (size_t)truth_view->size.width * (size_t)truth_view->size.height;
    uint64_t content = content_of(truth_view->visibility, truth_view->noise, pixels);
    FILE *file = fopen(path, "wb");
    if (file && fwrite(truth_view->visibility, sizeof(float), pixels, file) == pixels &&
        fwrite(truth_view->noise, sizeof(float), pixels, file) == pixels)
        fwrite(&content, sizeof content, 1, file);
    if (file)
        fclose(file);
}

static bool trace(TruthView *truth_view, const StudyScene *scene, const char *folder) {
    char path[FILES_PATH];
    truth_path(path, folder, truth_view, &scene->query);
    if (recall(truth_view, path))
        return true;
    if (!truth_view_refine(truth_view, &scene->query, STUDY_ACROSS))
        return false;
    keep(truth_view, path);
    return true;
}

bool view_create_of(StudyView *view, const StudyScene *scene, const Scene *made, MetricsSize size,
                    const char *folder, LabArtist *artist) {
    TruthQuery centers = scene->query;
    *view = (StudyView){0};
    if (centers.samples > 0 && truth_is_soft(made, &centers))
        centers.samples = 1; // it is the whole pixels' truth that counts
    return truth_view_create(&view->truth_view, made, size, &centers, artist) &&
           trace(&view->truth_view, scene, folder) &&
           flip_create_grey(&view->flip, size, view->truth_view.visibility) &&
           (!scene->moves || artist->without || motion_create(&view->motion, scene, made, size, artist));
}

bool view_create(StudyView *view, const StudyScene *scene, int number, MetricsSize size, const char *folder,
                 LabArtist *artist) {
    Scene *made = calloc(1, sizeof *made);
    INVARIANT(made);
    views_make(scene, number, made);
    const bool ok = view_create_of(view, scene, made, size, folder, artist);
    free(made);
    return ok;
}

void view_destroy(StudyView *view) {
    truth_view_destroy(&view->truth_view);
    flip_destroy(&view->flip);
    motion_destroy(&view->motion);
    *view = (StudyView){0};
}

// FLIP of a frame that is as the truth where nothing counts.
static bool measure_flip(const StudyView *view, const Measured *frame, double *mean) {
    MetricsSize size = view->truth_view.size;
    size_t pixels = (size_t)size.width * (size_t)size.height;
    float *seen = malloc(pixels * sizeof *seen);
    FlipPicture flip = {0};
    for (size_t i = 0; seen && i < pixels; i++)
        seen[i] = frame->mask[i] ? frame->visibility[i] : view->truth_view.visibility[i];
    bool ok = seen ? flip_create_grey(&flip, size, seen) : check_fail("out of memory to compare a frame");
    if (ok)
        *mean = flip_mean(&view->flip, &flip, frame->mask);
    flip_destroy(&flip);
    free(seen);
    return ok;
}

// Mean difference to the truth at the pixels' centres.
static void sum_pixels(const TruthView *truth_view, const Measured *frame, MeasuredErrors *errors) {
    size_t pixels = (size_t)truth_view->size.width * (size_t)truth_view->size.height;
    double count = fmax((double)frame->metrics.all.pixels, 1);
    for (size_t i = 0; i < pixels; i++)
        if (frame->mask[i])
            errors->center += fabs((double)(frame->visibility[i] - truth_view->center[i])) / count;
}

bool view_compare(const StudyView *view, const StudyScene *scene, const Setting *setting, Measured *frame,
                  MeasuredErrors *errors) {
    const TruthView *truth_view = &view->truth_view;
    truth_view_compare(truth_view, setting, frame);
    const MetricsPart *edge = &frame->metrics.edge, *interior = &frame->metrics.interior;
    double length =
        scene->edges ? edge_length(truth_view->size, truth_view->traced, frame->mask, truth_view->visibility)
                     : 0;
    *errors = (MeasuredErrors){.edge_false_shadow = edge->false_shadow,
                               .edge_false_light = edge->false_light,
                               .interior_false_shadow = interior->false_shadow,
                               .interior_false_light = interior->false_light,
                               .off = edge_error(&frame->metrics, length),
                               .rmse = frame->metrics.all.rmse};
    sum_pixels(truth_view, frame, errors);
    return measure_flip(view, frame, &errors->flip);
}
