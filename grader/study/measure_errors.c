// Draws or traces a frame of a setting in each view and compares it, unless the state knows.
#include "study/measure_errors.h"

#include "base/hash.h"
#include "scene/check.h"
#include "study/counted_frame.h"
#include "study/edge.h"
#include "study/pictures.h"
#include "study/rays.h"

#include <string.h>

enum { VERSION = 6 }; // of what is measured

// What is measured, as a number: the same only for the same frame of the same scene by the same code.
static uint64_t make_key(const StudyPlan *plan, uint64_t hash, const TruthView *truth_view,
                         const StudyScene *scene, const Method *method) {
    const TruthQuery *query = &scene->query;
    const int32_t numbers[] = {VERSION,
                               truth_view->size.width,
                               truth_view->size.height,
                               (int32_t)query->kind,
                               query->samples,
                               (int32_t)query->seed,
                               scene->edges,
                               scene->moves,
                               method->submission,
                               method->rays};
    hash = hash_bytes(hash, numbers, sizeof numbers);
    hash = hash_bytes(hash, plan->renderer, strlen(plan->renderer));
    hash = hash_bytes(hash, &query->area, sizeof query->area);
    hash = hash_bytes(hash, &query->limit, sizeof query->limit);
    hash = hash_bytes(hash, &truth_view->truth.scene, sizeof truth_view->truth.scene);
    hash = hash_bytes(hash, &method->kernel, sizeof method->kernel);
    for (int i = 0; i < method->setting.knob_count; i++) {
        const KnobSetting *knob = &method->setting.knobs[i];
        hash = hash_bytes(hash, knob->name, strlen(knob->name));
        hash = hash_bytes(hash, &knob->value, sizeof knob->value);
    }
    return hash;
}

// Half width of the edge zone: the kernel and one texel, as large as they are in the picture.
static void set_edge(const TruthView *truth_view, const StudyScene *scene, Method *method) {
    double texel = method->map_size > 0 ? edge_map_side(truth_view) / method->map_size : 0;
    float width = metrics_edge_width(method->kernel * (float)texel, (float)texel);
    method->setting.edge_width = scene->edges ? width : METHOD_NO_EDGE;
}

// By rays: the frame whose error is measured is the one whose time counts, too.
static bool draw_rays(StudyPlan *plan, const StudyView *view, const StudyScene *scene, const Method *method,
                      uint64_t key, Measured *frame) {
    MeasuredTime time;
    if (!measured_create(frame, view->truth_view.size) ||
        !rays_draw(view, scene, method->rays, frame->visibility, &time))
        return false;
    time.key = key;
    return measurements_add_time(&plan->state, &time);
}

// Rays of other random numbers in each frame would flicker by their number alone: they are not asked.
static bool measure_motion(const StudyView *view, const StudyScene *scene, LabArtist *artist,
                           const Method *method, MeasuredErrors *errors) {
    double beyond[MOTION_KINDS] = {0};
    bool ok = !scene->moves || method->rays || !artist || artist->without ||
              motion_measure(&view->motion, artist, &method->setting, beyond);
    errors->turning = beyond[MOTION_LIGHT];
    errors->moving = beyond[MOTION_CAMERA];
    return ok;
}

static bool count(LabArtist *artist, const StudyView *view, const Method *method, MeasuredErrors *errors) {
    const Request request = truth_view_request(&view->truth_view, &method->setting);
    return counted_frame(artist, &request, errors);
}

// Measures one view; its picture is kept under `path`, and its frame counted. NULL: neither.
static bool measure(StudyPlan *plan, LabArtist *artist, const StudyView *view, const StudyScene *scene,
                    Method *method, uint64_t key, const char *path, MeasuredErrors *errors) {
    Measured frame = {0};
    set_edge(&view->truth_view, scene, method);
    bool ok = method->rays ? draw_rays(plan, view, scene, method, key, &frame)
                           : truth_view_measure(&view->truth_view, artist, &method->setting, true, &frame);
    ok = ok && view_compare(view, scene, &method->setting, &frame, errors) &&
         measure_motion(view, scene, artist, method, errors) &&
         (!path || (pictures_write(path, view->truth_view.size, frame.visibility, NULL) &&
                    (method->rays || count(artist, view, method, errors)))) &&
         measurements_add_errors(&plan->state, key, errors);
    measured_destroy(&frame);
    return ok;
}

static bool find_view(StudyPlan *plan, LabArtist *artist, const StudyView *view, const StudyScene *scene,
                      Finding *finding, int number) {
    char path[FILES_PATH];
    const uint64_t start = artist ? lab_artists_key(artist) : HASH_START;
    uint64_t key = make_key(plan, start, &view->truth_view, scene, &finding->method);
    finding->keys[number] = key;
    pictures_frame_path(path, plan->output, key);
    const MeasuredErrors *known = measurements_errors(&plan->state, key);
    if (known && (number > 0 || files_exists(path))) {
        finding->views[number] = *known;
        return true;
    }
    return measure(plan, artist, view, scene, &finding->method, key, number > 0 ? NULL : path,
                   &finding->views[number]);
}

bool measure_errors(StudyPlan *plan, const StudyView views[STUDY_VIEWS], const StudyScene *scene,
                    Finding *finding) {
    LabArtist *artist = finding->method.rays ? NULL : lab_artists_get(&plan->artists, &finding->method);
    bool ok = artist || finding->method.rays;
    for (int v = 0; ok && v < STUDY_VIEWS; v++)
        ok = find_view(plan, artist, &views[v], scene, finding, v);
    finding->drawn = ok;
    return ok;
}
