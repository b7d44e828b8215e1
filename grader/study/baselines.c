// Frames that take no method, compared as those of methods are.
#include "study/baselines.h"

#include "scene/check.h"
#include "scene/count.h"
#include "truth/pixels.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const float lengths[] = {0.25f, 0.5f, 1}; // of rays in an endless sky, world units
enum { LENGTH_RAYS = 256 };

static Baseline *find(Baselines *lines, const char *name) {
    for (int i = 0; i < lines->count; i++)
        if (strcmp(lines->lines[i].name, name) == 0)
            return &lines->lines[i];
    INVARIANT(lines->count < BASELINES_MOST);
    Baseline *line = &lines->lines[lines->count++];
    *line = (Baseline){0};
    snprintf(line->name, sizeof line->name, "%s", name);
    return line;
}

// Counts the frame, which is there, as one of `views` of the line of this name.
static bool add_frame(Baselines *lines, const char *name, const StudyScene *scene, const StudyView *view,
                      Measured *frame, int views) {
    const Setting setting = {.edge_width = scene->edges ? 0 : METHOD_NO_EDGE, .object = TRUTH_NONE};
    MeasuredErrors errors;
    if (!view_compare(view, scene, &setting, frame, &errors))
        return false;
    Baseline *line = find(lines, name);
    measured_errors_add(&line->errors, &errors, 1.0 / views);
    line->worst_inside = fmax(line->worst_inside, errors.interior_false_shadow + errors.interior_false_light);
    line->worst_off = fmax(line->worst_off, errors.off);
    return true;
}

static bool add_even(Baselines *lines, const char *name, float value, const StudyScene *scene,
                     const StudyView *view, Measured *frame, int views) {
    for (ptrdiff_t i = 0; i < (ptrdiff_t)view->truth_view.size.width * view->truth_view.size.height; i++)
        frame->visibility[i] = value;
    return add_frame(lines, name, scene, view, frame, views);
}

static bool add_floor(Baselines *lines, const StudyScene *scene, const StudyView *view, Measured *frame,
                      int views) {
    const TruthView *truth_view = &view->truth_view;
    for (ptrdiff_t i = 0; i < (ptrdiff_t)truth_view->size.width * truth_view->size.height; i++)
        frame->visibility[i] = truth_view->visibility[i] + truth_view->noise[i];
    static const char name[] = "the truth's own noise";
    bool ok = add_frame(lines, name, scene, view, frame, views);
    find(lines, name)->is_floor = true;
    return ok;
}

static bool add_centers(Baselines *lines, const StudyScene *scene, const StudyView *view, Measured *frame,
                        int views) {
    size_t pixels = (size_t)view->truth_view.size.width * (size_t)view->truth_view.size.height;
    memcpy(frame->visibility, view->truth_view.center, pixels * sizeof *frame->visibility);
    return add_frame(lines, "one sample a pixel can do no better", scene, view, frame, views);
}

static bool add_lengths(Baselines *lines, const StudyScene *scene, const StudyView *view, Measured *frame,
                        int views) {
    bool ok = true;
    for (size_t i = 0; ok && i < COUNT(lengths); i++) {
        char name[BASELINE_NAME];
        TruthQuery query = scene->query;
        query.limit = lengths[i];
        query.samples = LENGTH_RAYS;
        snprintf(name, sizeof name, "rays of length %g", (double)lengths[i]);
        ok = pixels_trace(&view->truth_view.truth, &view->truth_view.picture, &query, STUDY_ACROSS,
                          frame->visibility) &&
             add_frame(lines, name, scene, view, frame, views);
    }
    return ok;
}

bool baselines_add(Baselines *lines, const StudyScene *scene, const StudyView *view, int views) {
    Measured frame;
    bool is_sky = scene->query.kind == TRUTH_OCCLUSION,
         is_hard = !truth_is_soft(&view->truth_view.truth.scene, &scene->query);
    bool ok = measured_create(&frame, view->truth_view.size);
    ok = ok && add_even(lines, is_sky ? "white" : "no shadow", 1, scene, view, &frame, views);
    ok = ok && add_even(lines, is_sky ? "black" : "all shadow", 0, scene, view, &frame, views);
    ok = ok && add_floor(lines, scene, view, &frame, views);
    ok = ok && (!is_hard || add_centers(lines, scene, view, &frame, views));
    ok = ok && (!is_sky || scene->query.limit > 0 || add_lengths(lines, scene, view, &frame, views));
    measured_destroy(&frame);
    return ok;
}

const Baseline *baselines_floor(const Baselines *lines) {
    for (int i = 0; i < lines->count; i++)
        if (lines->lines[i].is_floor)
            return &lines->lines[i];
    return NULL;
}
