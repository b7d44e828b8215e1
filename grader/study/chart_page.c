// Puts the page together from chart_page.html and scripts beside it, and all points of all scenes as JSON in
// it.
#include "study/chart_page.h"

#include "study/chart_label.h"
#include "study/chart_svg.h"
#include "scene/check.h"
#include "base/files.h"
#include "study/pictures.h"
#include "study/verdict.h"
#include "pages/page.h"
#include "pages/template.h"

#include <errno.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

static const char template_file[] = "grader/study/chart_page.html", scenes[] = "scenes";

// Writes the template from where it is up to the hole of the scenes, or to its end; other holes name files.
static bool write_template(Template *template, FILE *out) {
    const char *hole;
    char file[FILES_PATH];
    while ((hole = template_next(template, out)) && strcmp(hole, scenes) != 0) {
        files_join(file, "grader/study", hole);
        if (out && !template_copy(out, file))
            return false;
    }
    return true;
}

bool chart_page_begin(FILE *out) {
    Template template = {0};
    bool ok = page_begin_shell(out, "Speed against accuracy", "grader/study/chart_page.css") &&
              template_open(&template, template_file) && write_template(&template, out);
    template_close(&template);
    return ok;
}

bool chart_page_end(FILE *out) {
    Template template = {0};
    bool ok = template_open(&template, template_file) && write_template(&template, NULL) &&
              write_template(&template, out) && page_end_shell(out);
    template_close(&template);
    return ok;
}

static bool read_bytes(const char *path, uint8_t **bytes, size_t *size) {
    FILE *file = fopen(path, "rb");
    if (!file)
        return check_fail("%s: %s", path, strerror(errno));
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    *bytes = malloc(*size + 1);
    bool ok = *bytes && fread(*bytes, 1, *size, file) == *size;
    fclose(file);
    return ok || check_fail("%s cannot be read", path);
}

// A PNG as a data URL; NULL with a message.
static json_t *picture(const char *path) {
    uint8_t *bytes = NULL;
    size_t size = 0, length = 0;
    json_t *url = NULL;
    char *text = NULL;
    if (read_bytes(path, &bytes, &size)) {
        Page page = {.out = open_memstream(&text, &length)};
        INVARIANT(page.out);
        page_data(&page, "image/png", bytes, size);
        fclose(page.out);
        url = json_string(text);
    }
    free(text);
    free(bytes);
    return url;
}

static json_t *errors_json(const MeasuredErrors *e) {
    return json_pack("{s:f, s:f, s:f, s:f, s:f}", "edgeShadow", e->edge_false_shadow, "edgeLight",
                     e->edge_false_light, "insideShadow", e->interior_false_shadow, "insideLight",
                     e->interior_false_light, "off", e->off);
}

// What a chart needs beside the numbers: the spread over the views, a short name, and from where a curve
// comes.
static json_t *drawing_json(const SceneFindings *findings, int i) {
    const Finding *f = &findings->findings[i];
    char label[LABEL_TEXT];
    double low, high;
    int before = label_before(findings, i);
    label_write(f->method.name, label);
    finding_range(f, &low, &high);
    return json_pack("{s:f, s:f, s:f, s:f, s:f, s:f, s:f, s:s, s:s, s:i, s:f, s:b}", "rmse", f->errors.rmse,
                     "flip", f->errors.flip, "center", f->errors.center, "turning", f->errors.turning,
                     "moving", f->errors.moving, "low", low, "high", high, "label", label, "from",
                     before < 0 ? "" : findings->findings[before].method.name, "enoughViews", f->enough_views,
                     "worstOff", f->worst_off, "traced", f->method.rays > 0);
}

static void join(json_t *object, json_t *more) {
    json_object_update(object, more);
    json_decref(more);
}

static json_t *lines_json(const Baselines *lines) {
    json_t *all = json_array();
    for (int i = 0; i < lines->count; i++) {
        const Baseline *line = &lines->lines[i];
        json_array_append_new(all, json_pack("{s:s, s:f, s:f, s:f, s:b}", "name", line->name, "error",
                                             finding_error(&line->errors), "rmse", line->errors.rmse, "flip",
                                             line->errors.flip, "floor", line->is_floor));
    }
    return all;
}

static json_t *point_json(const SceneFindings *findings, int i, json_t *frame) {
    const Finding *f = &findings->findings[i];
    const Point *p = &findings->points[i];
    json_t *point = json_pack("{s:s, s:s, s:s, s:i, s:s, s:b, s:b, s:b, s:b, s:f, s:f, s:f, s:f}", "lab",
                              f->method.lab, "method", f->method.family, "setting", f->method.name, "family",
                              label_family(findings, f->method.family, f->method.submission), "color",
                              label_color(findings, &f->method), "submission", f->method.submission, "front",
                              p->on_front, "enough", f->enough, "chosen", f->chosen, "ms", p->ms, "mad",
                              p->mad, "shade", f->shade_ms, "shadeMad", f->shade_mad);
    json_t *rest = json_pack("{s:f, s:f, s:f, s:f, s:f, s:f, s:f, s:f, s:f, s:i, s:o, s:o}", "prepare",
                             f->prepare_ms, "prepareMad", f->prepare_mad, "error", p->error, "taps",
                             f->cost.taps, "texels", f->cost.texels, "fragments", f->cost.fragments, "rays",
                             f->cost.rays, "bytes", f->cost.bytes, "counted", f->cost.counted, "frames",
                             f->frames, "errors", errors_json(&f->errors), "frame", frame);
    join(point, rest);
    join(point, drawing_json(findings, i));
    return point;
}

static bool add_points(json_t *points, const StudyPlan *plan, const SceneFindings *findings) {
    for (int i = 0; i < findings->count; i++) {
        char path[FILES_PATH];
        if (!findings->findings[i].drawn)
            continue;
        pictures_frame_path(path, plan->output, findings->findings[i].keys[0]);
        json_t *frame = picture(path);
        if (!frame)
            return false;
        json_array_append_new(points, point_json(findings, i, frame));
    }
    return true;
}

bool chart_page_add(FILE *file, const StudyPlan *plan, const SceneFindings *findings, bool is_first) {
    char path[FILES_PATH], need[VERDICT_TEXT];
    const StudyScene *scene = findings->scene;
    json_t *points = json_array();
    pictures_path(path, plan->output, scene->name);
    json_t *truth = picture(path);
    findings_tell(findings, need, sizeof need);
    bool ok = truth && add_points(points, plan, findings);
    json_t *all = json_pack("{s:s, s:s, s:s, s:s, s:f, s:b, s:b, s:s, s:s, s:i, s:i, s:o*, s:o, s:o, s:i}",
                            "name", scene->name, "title", scene->title, "shows", scene->shows, "need", need,
                            "tolerance", scene->tolerance, "edges", scene->edges, "moves", scene->moves,
                            "renderer", findings->renderer, "clock", findings->on_gpu ? "GPU" : "CPU",
                            "width", plan->size.width, "height", plan->size.height, "truth", truth, "points",
                            points, "lines", lines_json(&findings->lines), "views", STUDY_VIEWS);
    fputs(is_first ? "" : ",\n", file);
    ok = ok && json_dumpf(all, file, JSON_COMPACT | JSON_REAL_PRECISION(9)) == 0;
    json_decref(all);
    return ok;
}
