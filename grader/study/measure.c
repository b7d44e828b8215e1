#include "study/measure.h"

#include "scene/check.h"
#include "study/cost.h"
#include "study/edge.h"
#include "base/hash.h"
#include "study/pictures.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VERSION = 1, TURN = 3 }; // of what is measured; timed frames of a setting in a row

// Which passes of a lab come before the picture and which make it, as bits; others only show something.
typedef struct Passes {
    const char *lab;
    unsigned prepare, shade;
} Passes;

static const Passes all_passes[] = {{"03", 1, 2}, {"04", 1, 2},     {"05", 1, 2},
                                    {"06", 1, 2}, {"07", 2, 1 | 4}, {"08", 1 | 2, 4}};

static StateTime sum_passes(const Finding *finding, const float *milliseconds) {
    StateTime time = {.key = finding->key};
    const Passes *passes = all_passes;
    while (strcmp(passes->lab, finding->method.lab) != 0)
        passes++;
    for (unsigned i = 0; i < LAB_MAX_PASSES; i++) {
        time.prepare += passes->prepare >> i & 1 ? (double)milliseconds[i] : 0;
        time.shade += passes->shade >> i & 1 ? (double)milliseconds[i] : 0;
    }
    return time;
}

bool measure_concerns(const StudyScene *scene, const char *lab) {
    static MethodList list;
    list.count = 0;
    scene->add_methods(&list);
    for (int i = 0; i < list.count; i++)
        if (strcmp(list.methods[i].lab, lab) == 0)
            return true;
    return false;
}

// What is measured, as a number: the same only for the same frame of the same scene by the same code.
static uint64_t make_key(const Artist *artist, const Ground *ground, const StudyScene *scene,
                         const Method *method) {
    const TruthQuery *query = &scene->query;
    const int32_t numbers[] = {
        VERSION,        ground->size.width,   ground->size.height, (int32_t)query->kind,
        query->samples, (int32_t)query->seed, scene->edges,        method->submission};
    uint64_t hash = hash_bytes(crew_key(artist), numbers, sizeof numbers);
    hash = hash_bytes(hash, &query->area, sizeof query->area);
    hash = hash_bytes(hash, &ground->truth.scene, sizeof ground->truth.scene);
    hash = hash_bytes(hash, &method->kernel, sizeof method->kernel);
    for (int i = 0; i < method->setting.knob_count; i++) {
        const KnobSetting *knob = &method->setting.knobs[i];
        hash = hash_bytes(hash, knob->name, strlen(knob->name));
        hash = hash_bytes(hash, &knob->value, sizeof knob->value);
    }
    return hash;
}

// Share of the pixels that count and are neither wholly lit nor wholly dark.
static double partial(const Ground *ground, const Measured *measured) {
    size_t count = 0, pixels = (size_t)ground->size.width * (size_t)ground->size.height;
    for (size_t i = 0; i < pixels; i++)
        count += measured->mask[i] && measured->visibility[i] > 0 && measured->visibility[i] < 1;
    return measured->metrics.all.pixels ? (double)count / (double)measured->metrics.all.pixels : 0;
}

// Half width of the edge zone: the kernel and one texel, as large as they are in the picture.
static void set_edge(const Ground *ground, const StudyScene *scene, Method *method) {
    double texel = method->map_size > 0 ? edge_map_side(ground) / method->map_size : 0;
    float width = metrics_edge_width(method->kernel * (float)texel, (float)texel);
    method->setting.edge_width = scene->edges ? width : 1e-3f; // the boundary begins at half a pixel
}

static bool measure_errors(StudyPlan *plan, const Ground *ground, Artist *artist, const StudyScene *scene,
                           Finding *finding) {
    Measured measured = {0};
    char path[FILES_PATH];
    set_edge(ground, scene, &finding->method);
    finding->drawn = ground_measure(ground, artist, &finding->method.setting, true, &measured);
    bool ok = finding->drawn;
    if (ok) {
        const MetricsPart *edge = &measured.metrics.edge, *interior = &measured.metrics.interior;
        double length =
            scene->edges ? edge_length(ground->size, ground->traced, measured.mask, ground->visibility) : 0;
        finding->errors = (StateErrors){edge->false_shadow,
                                        edge->false_light,
                                        interior->false_shadow,
                                        interior->false_light,
                                        edge_error(&measured.metrics, length),
                                        partial(ground, &measured)};
        pictures_frame_path(path, plan->output, finding->key);
        ok = pictures_write(path, ground->size, measured.visibility, NULL) &&
             state_add_errors(&plan->state, finding->key, &finding->errors);
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

static bool find_errors(StudyPlan *plan, const Ground *ground, const StudyScene *scene, Finding *finding) {
    char path[FILES_PATH];
    Artist *artist = crew_get(&plan->crew, &finding->method);
    if (!artist)
        return excuse(finding);
    finding->key = make_key(artist, ground, scene, &finding->method);
    pictures_frame_path(path, plan->output, finding->key);
    const StateErrors *known = state_errors(&plan->state, finding->key);
    finding->drawn = known && files_exists(path);
    if (finding->drawn)
        finding->errors = *known;
    return finding->drawn || measure_errors(plan, ground, artist, scene, finding) || excuse(finding);
}

// One frame as its viewer sees it; its time counts where `counts`.
static bool time_frame(StudyPlan *plan, const Ground *ground, Finding *finding, bool counts) {
    static Reply reply;
    static Image image;
    Setting setting = finding->method.setting;
    setting.view = VIEW_PICTURE;
    const Request request = ground_request(ground, &setting);
    if (!artist_draw(crew_get(&plan->crew, &finding->method), &request, &image, &reply))
        return false;
    const StateTime time = sum_passes(finding, reply.milliseconds);
    return !counts || state_add_time(&plan->state, &time);
}

// A setting's turn: its resources are made anew, and the first frame, which touches them first, does not
// count.
static bool take_turn(StudyPlan *plan, const Ground *ground, Finding *finding) {
    if (finding->method.submission)
        client_begin(&crew_get(&plan->crew, &finding->method)->client); // the others' turns are not its time
    bool ok = time_frame(plan, ground, finding, false);
    for (int i = 0; ok && i < TURN && finding->frames < plan->frames; i++) {
        ok = time_frame(plan, ground, finding, true);
        finding->frames++;
        bar_step(&plan->bar);
    }
    return ok || excuse(finding);
}

static bool take_turns(StudyPlan *plan, const Ground *ground, Findings *findings) {
    bool left = true;
    while (left) {
        left = false;
        for (int i = 0; i < findings->count; i++) {
            Finding *finding = &findings->findings[i];
            if (!finding->drawn || finding->frames >= plan->frames)
                continue;
            if (!take_turn(plan, ground, finding))
                return false;
            left = true;
        }
    }
    return true;
}

static int count_known(const StudyPlan *plan, Findings *findings) {
    int known = 0;
    StateTime *times = calloc((size_t)plan->frames, sizeof *times);
    INVARIANT(times);
    for (int i = 0; i < findings->count; i++) {
        Finding *finding = &findings->findings[i];
        finding->frames =
            finding->drawn ? state_times(&plan->state, finding->key, times, plan->frames) : plan->frames;
        known += finding->frames;
    }
    free(times);
    return known;
}

static void sum_up(const StudyPlan *plan, const Ground *ground, Findings *findings) {
    StateTime *times = calloc((size_t)plan->frames, sizeof *times);
    INVARIANT(times);
    for (int i = 0; i < findings->count; i++) {
        Finding *finding = &findings->findings[i];
        if (!finding->drawn)
            continue;
        int count = state_times(&plan->state, finding->key, times, plan->frames);
        finding_time(finding, &findings->points[i], times, count);
        finding->cost =
            cost_of(&finding->method, &ground->truth.scene, ground->size, finding->errors.partial);
    }
    free(times);
    findings_judge(findings);
}

static bool measure_ground(StudyPlan *plan, const Ground *ground, Findings *findings) {
    bool ok = true;
    for (int i = 0; ok && i < findings->count; i++)
        ok = find_errors(plan, ground, findings->scene, &findings->findings[i]);
    if (!ok)
        return false;
    bar_begin(&plan->bar, findings->scene->name, count_known(plan, findings), plan->frames * findings->count);
    ok = take_turns(plan, ground, findings);
    bar_end(&plan->bar);
    if (ok)
        sum_up(plan, ground, findings);
    return ok;
}

static void list_methods(const StudyPlan *plan, const StudyScene *scene, Findings *findings) {
    static MethodList list;
    list.count = 0;
    scene->add_methods(&list);
    *findings = (Findings){.scene = scene};
    for (int i = 0; i < list.count; i++)
        findings->findings[findings->count++].method = list.methods[i];
    for (int i = 0; i < list.count && plan->crew.submission; i++) {
        if (strcmp(list.methods[i].lab, plan->crew.submission_lab) != 0)
            continue;
        INVARIANT(findings->count < METHOD_MOST);
        Method *method = &findings->findings[findings->count++].method;
        *method = list.methods[i];
        method->submission = true;
    }
}

static bool write_truth(const StudyPlan *plan, const Ground *ground, const StudyScene *scene) {
    char path[FILES_PATH];
    size_t pixels = (size_t)ground->size.width * (size_t)ground->size.height;
    uint8_t *mask = calloc(pixels, 1);
    const MetricsPixels given = {ground->drawn, ground->traced, ground->facing, ground->visibility};
    INVARIANT(mask);
    metrics_mask(ground->size, &given, mask);
    pictures_path(path, plan->output, scene->name);
    bool ok = pictures_write(path, ground->size, ground->visibility, mask);
    free(mask);
    return ok;
}

bool measure_scene(StudyPlan *plan, const StudyScene *scene, Findings *findings) {
    static Scene made;
    Ground ground = {0};
    list_methods(plan, scene, findings);
    scene->make(&made);
    Artist *artist = crew_get(&plan->crew, &findings->findings[0].method);
    bool ok = artist && ground_create(&ground, &made, plan->size, &scene->query, artist) &&
              write_truth(plan, &ground, scene) && measure_ground(plan, &ground, findings);
    ground_destroy(&ground);
    return ok;
}
