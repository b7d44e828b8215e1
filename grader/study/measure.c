// For each setting of a scene: errors once against the truth, then times in turns, one setting after the
// other; what the state holds already is not measured again.
#include "study/measure.h"

#include "scene/check.h"
#include "study/cost.h"
#include "study/measure_errors.h"
#include "study/pictures.h"
#include "study/rays.h"
#include "study/verdict.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TURN = 5 }; // timed frames of a setting in a row

// Passes of the solution; those of a submission's table are the same ones.
static bool sum_passes(StudyPlan *plan, const Finding *finding, const Reply *reply, MeasuredTime *time) {
    const bool on_gpu = plan->artists.context == CONTEXT_EGL;
    const float *shading = on_gpu ? reply->gpu_milliseconds : reply->milliseconds;
    const float *preparing = on_gpu && !finding->method.by_processor ? shading : reply->milliseconds;
    Method ours = finding->method;
    ours.submission = false;
    LabArtist *artist = lab_artists_get(&plan->artists, &ours);
    const int32_t *kinds = artist ? lab_artist_pass_kinds(artist) : NULL;
    *time = (MeasuredTime){0};
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

// A submission that does not draw is what we find out about it.
static bool excuse(Finding *finding) {
    if (!finding->method.submission)
        return false;
    finding->drawn = false;
    snprintf(finding->message, sizeof finding->message, "%s", check_message());
    check_clear();
    return true;
}

// One frame as its viewer sees it.
static bool time_frame(StudyPlan *plan, const StudyView *view, const Finding *finding, MeasuredTime *time) {
    static Reply reply;
    static Image image;
    Setting setting = finding->method.setting;
    setting.view = VIEW_PICTURE;
    Request request = truth_view_request(&view->truth_view, &setting);
    request.gpu_times = plan->artists.context == CONTEXT_EGL;
    return lab_artist_draw(lab_artists_get(&plan->artists, &finding->method), &request, &image, &reply) &&
           sum_passes(plan, finding, &reply, time);
}

// The frames of a setting that one view gets; ray tracing is timed with its errors, once.
static int share(const StudyPlan *plan, const Finding *finding, int view) {
    int frames = finding->method.rays ? STUDY_VIEWS : plan->frames;
    return (view + 1) * frames / STUDY_VIEWS - view * frames / STUDY_VIEWS;
}

// A setting's turn in a view: its resources are made again, and the first frame, which touches them first,
// does not count.
static bool take_turn(StudyPlan *plan, const StudyView *views, int v, Finding *finding) {
    MeasuredTime time;
    if (finding->method.submission)
        worker_client_begin(
            &lab_artists_get(&plan->artists, &finding->method)->client); // the others' turns are not its time
    bool ok = time_frame(plan, &views[v], finding, &time);
    for (int i = 0; ok && i < TURN && finding->timed[v] < share(plan, finding, v); i++) {
        ok = time_frame(plan, &views[v], finding, &time);
        time.key = finding->keys[v];
        ok = ok && measurements_add_time(&plan->state, &time);
        finding->timed[v]++;
        progress_bar_step(&plan->bar, NULL, false);
    }
    return ok || excuse(finding);
}

// One turn of each setting that has not yet all frames of this view; `left` says whether there was one.
static bool take_round(StudyPlan *plan, const StudyView *views, int v, SceneFindings *findings, bool *left) {
    for (int i = 0; i < findings->count; i++) {
        Finding *finding = &findings->findings[i];
        if (!finding->drawn || finding->timed[v] >= share(plan, finding, v))
            continue;
        if (!take_turn(plan, views, v, finding))
            return false;
        *left = true;
    }
    return true;
}

static bool take_turns(StudyPlan *plan, const StudyView *views, SceneFindings *findings) {
    bool left = true, ok = true;
    while (ok && left) {
        left = false;
        for (int v = 0; ok && v < STUDY_VIEWS; v++)
            ok = take_round(plan, views, v, findings, &left);
    }
    return ok;
}

static int count_wanted(const StudyPlan *plan, const SceneFindings *findings) {
    int wanted = 0;
    for (int i = 0; i < findings->count; i++)
        for (int v = 0; v < STUDY_VIEWS; v++)
            wanted += share(plan, &findings->findings[i], v);
    return wanted;
}

// Frames of all settings whose times the state holds.
static int count_known(const StudyPlan *plan, SceneFindings *findings) {
    int known = 0;
    MeasuredTime *times = calloc((size_t)plan->frames + STUDY_VIEWS, sizeof *times);
    INVARIANT(times);
    for (int i = 0; i < findings->count; i++)
        for (int v = 0; v < STUDY_VIEWS; v++) {
            Finding *finding = &findings->findings[i];
            int all = share(plan, finding, v);
            finding->timed[v] =
                finding->drawn ? measurements_times(&plan->state, finding->keys[v], times, all) : all;
            known += finding->timed[v];
        }
    free(times);
    return known;
}

static void sum_up(const StudyPlan *plan, const TruthView *truth_view, SceneFindings *findings) {
    MeasuredTime *times = calloc((size_t)plan->frames + STUDY_VIEWS, sizeof *times);
    INVARIANT(times);
    for (int i = 0; i < findings->count; i++) {
        Finding *finding = &findings->findings[i];
        if (!finding->drawn)
            continue;
        int count = 0;
        for (int v = 0; v < STUDY_VIEWS; v++)
            count +=
                measurements_times(&plan->state, finding->keys[v], times + count, share(plan, finding, v));
        finding_time(finding, &findings->points[i], times, count);
        finding_errors(finding);
        finding->cost =
            cost_of(&finding->method, &truth_view->truth.scene, truth_view->size, &finding->views[0]);
    }
    free(times);
    findings_judge(findings);
}

static bool measure_views(StudyPlan *plan, const StudyView *views, SceneFindings *findings) {
    bool ok = true;
    for (int i = 0; ok && i < findings->count; i++)
        ok = measure_errors(plan, views, findings->scene, &findings->findings[i]) ||
             excuse(&findings->findings[i]);
    for (int v = 0; ok && v < STUDY_VIEWS; v++)
        ok = baselines_add(&findings->lines, findings->scene, &views[v], STUDY_VIEWS);
    if (!ok)
        return false;
    progress_bar_begin(&plan->bar, stderr, findings->scene->name, count_wanted(plan, findings),
                       count_known(plan, findings));
    ok = take_turns(plan, views, findings);
    fprintf(stderr, "%s: done in %.0f s\n", findings->scene->name, progress_bar_end(&plan->bar));
    if (ok)
        sum_up(plan, &views[0].truth_view, findings);
    return ok;
}

// A submission's C is compiled as it was handed in: for a measurement only its shaders can be changed.
static bool changes_c(const Change *change) {
    for (int i = 0; change && i < change->edit_count; i++) {
        const char *dot = strrchr(change->edits[i].file, '.');
        if (dot && (strcmp(dot, ".c") == 0 || strcmp(dot, ".h") == 0))
            return true;
    }
    return false;
}

static void list_methods(const StudyPlan *plan, const StudyScene *scene, SceneFindings *findings) {
    static MethodList list;
    study_add_methods(&list, scene);
    *findings = (SceneFindings){.scene = scene};
    // A processor's rays do not stand beside a GPU's times, the truth of dust takes none, and they are never
    // chosen, which is what is asked without an object.
    if (plan->artists.context != CONTEXT_EGL && scene->query.kind != TRUTH_DUST && !plan->artists.without)
        rays_add_methods(&list);
    for (int i = 0; i < list.count; i++)
        findings->findings[findings->count++].method = list.methods[i];
    for (int i = 0; i < list.count && plan->artists.submission; i++) {
        if (strcmp(list.methods[i].lab, plan->artists.submission_lab) != 0 ||
            changes_c(list.methods[i].change))
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

static bool make_views(StudyPlan *plan, const StudyScene *scene, LabArtist *artist, StudyView *views) {
    bool ok = artist != NULL;
    for (int v = 0; ok && v < STUDY_VIEWS; v++)
        ok = view_create(&views[v], scene, v, plan->size, plan->output, artist);
    if (ok) // by the frame of the triangles
        memcpy(plan->renderer, artist->renderer, sizeof plan->renderer);
    return ok;
}

bool measure_scene(StudyPlan *plan, const StudyScene *scene, SceneFindings *findings) {
    StudyView *views = calloc(STUDY_VIEWS, sizeof *views);
    INVARIANT(views);
    list_methods(plan, scene, findings);
    LabArtist *artist = lab_artists_get(&plan->artists, &findings->findings[0].method);
    bool ok = make_views(plan, scene, artist, views);
    findings->renderer = plan->renderer;
    findings->on_gpu = plan->artists.context == CONTEXT_EGL;
    findings->size = plan->size;
    ok = ok && write_truth(plan, &views[0].truth_view, scene) && measure_views(plan, views, findings);
    for (int v = 0; v < STUDY_VIEWS; v++)
        view_destroy(&views[v]);
    free(views);
    return ok;
}
