// For each setting of a scene: errors once against the truth, then times in turns, one setting after the
// other; what the state holds already is not measured again.
#include "study/measure.h"

#include "scene/check.h"
#include "study/cost.h"
#include "study/edge.h"
#include "base/hash.h"
#include "study/pictures.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VERSION = 2, TURN = 3 }; // of what is measured; timed frames of a setting in a row

// Passes of the solution; those of a submission's table are the same ones.
static bool sum_passes(StudyPlan *plan, const Finding *finding, const Reply *reply, MeasuredTime *time) {
    const bool on_gpu = plan->artists.context == CONTEXT_EGL;
    const float *shading = on_gpu ? reply->gpu_milliseconds : reply->milliseconds;
    const float *preparing = on_gpu && !finding->method.by_processor ? shading : reply->milliseconds;
    Method ours = finding->method;
    ours.submission = false;
    LabArtist *artist = lab_artists_get(&plan->artists, &ours);
    const int32_t *kinds = artist ? lab_artist_pass_kinds(artist) : NULL;
    *time = (MeasuredTime){.key = finding->key};
    for (int i = 0; kinds && i < LAB_MAX_PASSES; i++) {
        time->prepare += kinds[i] == PASS_PREPARE ? (double)preparing[i] : 0;
        time->shade += kinds[i] == PASS_PICTURE ? (double)shading[i] : 0;
    }
    return kinds != NULL;
}

bool measure_concerns(const StudyScene *scene, const char *lab) {
    static MethodList list;
    study_add_methods(&list, scene);
    for (int i = 0; i < list.count; i++)
        if (strcmp(list.methods[i].lab, lab) == 0)
            return true;
    return false;
}

// What is measured, as a number: the same only for the same frame of the same scene by the same code.
static uint64_t make_key(const StudyPlan *plan, const LabArtist *artist, const TruthView *truth_view,
                         const StudyScene *scene, const Method *method) {
    const TruthQuery *query = &scene->query;
    const int32_t numbers[] = {VERSION,
                               truth_view->size.width,
                               truth_view->size.height,
                               (int32_t)query->kind,
                               query->samples,
                               (int32_t)query->seed,
                               scene->edges,
                               method->submission};
    uint64_t hash = hash_bytes(lab_artists_key(artist), numbers, sizeof numbers);
    hash = hash_bytes(hash, plan->renderer, strlen(plan->renderer));
    hash = hash_bytes(hash, &query->area, sizeof query->area);
    hash = hash_bytes(hash, &truth_view->truth.scene, sizeof truth_view->truth.scene);
    hash = hash_bytes(hash, &method->kernel, sizeof method->kernel);
    for (int i = 0; i < method->setting.knob_count; i++) {
        const KnobSetting *knob = &method->setting.knobs[i];
        hash = hash_bytes(hash, knob->name, strlen(knob->name));
        hash = hash_bytes(hash, &knob->value, sizeof knob->value);
    }
    return hash;
}

// Share of the pixels that count and are neither wholly lit nor wholly dark.
static double partial(const TruthView *truth_view, const Measured *measured) {
    size_t count = 0, pixels = (size_t)truth_view->size.width * (size_t)truth_view->size.height;
    for (size_t i = 0; i < pixels; i++)
        count += measured->mask[i] && measured->visibility[i] > 0 && measured->visibility[i] < 1;
    return measured->metrics.all.pixels ? (double)count / (double)measured->metrics.all.pixels : 0;
}

// Half width of the edge zone: the kernel and one texel, as large as they are in the picture.
static void set_edge(const TruthView *truth_view, const StudyScene *scene, Method *method) {
    double texel = method->map_size > 0 ? edge_map_side(truth_view) / method->map_size : 0;
    float width = metrics_edge_width(method->kernel * (float)texel, (float)texel);
    method->setting.edge_width = scene->edges ? width : 1e-3f; // the boundary begins at half a pixel
}

static bool measure_errors(StudyPlan *plan, const TruthView *truth_view, LabArtist *artist,
                           const StudyScene *scene, Finding *finding) {
    Measured measured = {0};
    char path[FILES_PATH];
    set_edge(truth_view, scene, &finding->method);
    finding->drawn = truth_view_measure(truth_view, artist, &finding->method.setting, true, &measured);
    bool ok = finding->drawn;
    if (ok) {
        const MetricsPart *edge = &measured.metrics.edge, *interior = &measured.metrics.interior;
        double length = scene->edges ? edge_length(truth_view->size, truth_view->traced, measured.mask,
                                                   truth_view->visibility)
                                     : 0;
        finding->errors = (MeasuredErrors){edge->false_shadow,
                                           edge->false_light,
                                           interior->false_shadow,
                                           interior->false_light,
                                           edge_error(&measured.metrics, length),
                                           partial(truth_view, &measured)};
        pictures_frame_path(path, plan->output, finding->key);
        ok = pictures_write(path, truth_view->size, measured.visibility, NULL) &&
             measurements_add_errors(&plan->state, finding->key, &finding->errors);
    }
    measured_destroy(&measured);
    return ok;
}

// A submission that does not draw is what we find out about it.
static bool excuse(Finding *finding) {
    if (!finding->method.submission)
        return false;
    finding->drawn = false;
    snprintf(finding->message, sizeof finding->message, "%s", check_message());
    check_clear();
    return true;
}

static bool find_errors(StudyPlan *plan, const TruthView *truth_view, const StudyScene *scene,
                        Finding *finding) {
    char path[FILES_PATH];
    LabArtist *artist = lab_artists_get(&plan->artists, &finding->method);
    if (!artist)
        return excuse(finding);
    finding->key = make_key(plan, artist, truth_view, scene, &finding->method);
    pictures_frame_path(path, plan->output, finding->key);
    const MeasuredErrors *known = measurements_errors(&plan->state, finding->key);
    finding->drawn = known && files_exists(path);
    if (finding->drawn)
        finding->errors = *known;
    return finding->drawn || measure_errors(plan, truth_view, artist, scene, finding) || excuse(finding);
}

// One frame as its viewer sees it; its time counts where `counts`.
static bool time_frame(StudyPlan *plan, const TruthView *truth_view, Finding *finding, bool counts) {
    static Reply reply;
    static Image image;
    Setting setting = finding->method.setting;
    setting.view = VIEW_PICTURE;
    Request request = truth_view_request(truth_view, &setting);
    request.gpu_times = plan->artists.context == CONTEXT_EGL;
    if (!lab_artist_draw(lab_artists_get(&plan->artists, &finding->method), &request, &image, &reply))
        return false;
    MeasuredTime time;
    return sum_passes(plan, finding, &reply, &time) &&
           (!counts || measurements_add_time(&plan->state, &time));
}

// A setting's turn: its resources are made again, and the first frame, which touches them first, does not
// count.
static bool take_turn(StudyPlan *plan, const TruthView *truth_view, Finding *finding) {
    if (finding->method.submission)
        worker_client_begin(
            &lab_artists_get(&plan->artists, &finding->method)->client); // the others' turns are not its time
    bool ok = time_frame(plan, truth_view, finding, false);
    for (int i = 0; ok && i < TURN && finding->frames < plan->frames; i++) {
        ok = time_frame(plan, truth_view, finding, true);
        finding->frames++;
        progress_bar_step(&plan->bar, NULL, false);
    }
    return ok || excuse(finding);
}

static bool take_turns(StudyPlan *plan, const TruthView *truth_view, SceneFindings *findings) {
    bool left = true;
    while (left) {
        left = false;
        for (int i = 0; i < findings->count; i++) {
            Finding *finding = &findings->findings[i];
            if (!finding->drawn || finding->frames >= plan->frames)
                continue;
            if (!take_turn(plan, truth_view, finding))
                return false;
            left = true;
        }
    }
    return true;
}

static int count_known(const StudyPlan *plan, SceneFindings *findings) {
    int known = 0;
    MeasuredTime *times = calloc((size_t)plan->frames, sizeof *times);
    INVARIANT(times);
    for (int i = 0; i < findings->count; i++) {
        Finding *finding = &findings->findings[i];
        finding->frames = finding->drawn ? measurements_times(&plan->state, finding->key, times, plan->frames)
                                         : plan->frames;
        known += finding->frames;
    }
    free(times);
    return known;
}

static void sum_up(const StudyPlan *plan, const TruthView *truth_view, SceneFindings *findings) {
    MeasuredTime *times = calloc((size_t)plan->frames, sizeof *times);
    INVARIANT(times);
    for (int i = 0; i < findings->count; i++) {
        Finding *finding = &findings->findings[i];
        if (!finding->drawn)
            continue;
        int count = measurements_times(&plan->state, finding->key, times, plan->frames);
        finding_time(finding, &findings->points[i], times, count);
        finding->cost =
            cost_of(&finding->method, &truth_view->truth.scene, truth_view->size, finding->errors.partial);
    }
    free(times);
    findings_judge(findings);
}

static bool measure_ground(StudyPlan *plan, const TruthView *truth_view, SceneFindings *findings) {
    bool ok = true;
    for (int i = 0; ok && i < findings->count; i++)
        ok = find_errors(plan, truth_view, findings->scene, &findings->findings[i]);
    if (!ok)
        return false;
    progress_bar_begin(&plan->bar, stderr, findings->scene->name, plan->frames * findings->count,
                       count_known(plan, findings));
    ok = take_turns(plan, truth_view, findings);
    fprintf(stderr, "%s: done in %.0f s\n", findings->scene->name, progress_bar_end(&plan->bar));
    if (ok)
        sum_up(plan, truth_view, findings);
    return ok;
}

static void list_methods(const StudyPlan *plan, const StudyScene *scene, SceneFindings *findings) {
    static MethodList list;
    study_add_methods(&list, scene);
    *findings = (SceneFindings){.scene = scene};
    for (int i = 0; i < list.count; i++)
        findings->findings[findings->count++].method = list.methods[i];
    for (int i = 0; i < list.count && plan->artists.submission; i++) {
        if (strcmp(list.methods[i].lab, plan->artists.submission_lab) != 0)
            continue;
        INVARIANT(findings->count < METHOD_MOST);
        Method *method = &findings->findings[findings->count++].method;
        *method = list.methods[i];
        method->submission = true;
    }
}

static bool write_truth(const StudyPlan *plan, const TruthView *truth_view, const StudyScene *scene) {
    char path[FILES_PATH];
    size_t pixels = (size_t)truth_view->size.width * (size_t)truth_view->size.height;
    uint8_t *mask = calloc(pixels, 1);
    const MetricsPixels given = {truth_view->drawn, truth_view->traced, truth_view->facing,
                                 truth_view->visibility};
    INVARIANT(mask);
    metrics_mask(truth_view->size, &given, mask);
    pictures_path(path, plan->output, scene->name);
    bool ok = pictures_write(path, truth_view->size, truth_view->visibility, mask);
    free(mask);
    return ok;
}

bool measure_scene(StudyPlan *plan, const StudyScene *scene, SceneFindings *findings) {
    static Scene made;
    TruthView truth_view = {0};
    list_methods(plan, scene, findings);
    scene->make(&made);
    LabArtist *artist = lab_artists_get(&plan->artists, &findings->findings[0].method);
    bool ok = artist && truth_view_create(&truth_view, &made, plan->size, &scene->query, artist);
    if (ok) // by the frame of the triangles
        memcpy(plan->renderer, artist->renderer, sizeof plan->renderer);
    findings->renderer = plan->renderer;
    findings->on_gpu = plan->artists.context == CONTEXT_EGL;
    ok = ok && write_truth(plan, &truth_view, scene) && measure_ground(plan, &truth_view, findings);
    truth_view_destroy(&truth_view);
    return ok;
}
