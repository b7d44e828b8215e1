#include "study/findings_csv.h"

#include "scene/check.h"

#include <string.h>

void findings_csv_head(FILE *file) {
    fputs("scene,lab,whose,method,setting,frames,ms,ms_mad,prepare_ms,prepare_mad,shade_ms,shade_mad,error,"
          "false_shadow,"
          "false_light,edge_false_shadow,edge_false_light,interior_false_shadow,interior_false_light,edge_"
          "off_pixels,"
          "rmse,flip,center_error,error_low,error_high,worst_off_pixels,worst_interior,enough_views,"
          "taps,texels,fragments,rays,bytes,counted,on_front,enough,chosen,light_turns,camera_moves\n",
          file);
}

static void write_errors(FILE *file, const MeasuredErrors *e) {
    fprintf(file, "%.8f,%.8f,%.8f,%.8f,%.8f,%.8f,%.8f,%.5f,", finding_error(e),
            e->edge_false_shadow + e->interior_false_shadow, e->edge_false_light + e->interior_false_light,
            e->edge_false_shadow, e->edge_false_light, e->interior_false_shadow, e->interior_false_light,
            e->off);
    fprintf(file, "%.8f,%.8f,%.8f,", e->rmse, e->flip, e->center);
}

static void write_names(FILE *file, const SceneFindings *findings, const Finding *f) {
    fprintf(file, "%s,%s,%s,\"%s\",\"%s\",", findings->scene->name, f->method.lab,
            f->method.submission ? "submission" : "ours", f->method.family, f->method.name);
}

// Two last columns; empty where nothing moves or rays are traced.
static void write_motion(FILE *file, const SceneFindings *findings, const Finding *f,
                         const MeasuredErrors *e) {
    if (findings->scene->moves && !f->method.rays)
        fprintf(file, "%.8f,%.8f\n", e->turning, e->moving);
    else
        fputs(",\n", file);
}

void findings_csv_write(FILE *file, const SceneFindings *findings) {
    for (int i = 0; i < findings->count; i++) {
        const Finding *f = &findings->findings[i];
        const Point *point = &findings->points[i];
        double low, high;
        if (!f->drawn)
            continue;
        write_names(file, findings, f);
        fprintf(file, "%d,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,", f->frames, point->ms, point->mad, f->prepare_ms,
                f->prepare_mad, f->shade_ms, f->shade_mad);
        write_errors(file, &f->errors);
        finding_range(f, &low, &high);
        fprintf(file, "%.8f,%.8f,%.5f,%.8f,%d,", low, high, f->worst_off, f->worst_inside, f->enough_views);
        fprintf(file, "%.2f,%.0f,%.0f,%.0f,%.0f,%.0f,%d,%d,%d,", f->cost.taps, f->cost.texels,
                f->cost.fragments, f->cost.rays, f->cost.bytes, f->cost.counted, point->on_front, f->enough,
                f->chosen);
        write_motion(file, findings, f, &f->errors);
    }
}

void findings_csv_views_head(FILE *file) {
    fputs("scene,lab,whose,method,setting,view,error,interior_error,edge_off_pixels,rmse,flip,center_error,"
          "light_turns,"
          "camera_moves\n",
          file);
}

void findings_csv_views_write(FILE *file, const SceneFindings *findings) {
    for (int i = 0; i < findings->count; i++) {
        const Finding *f = &findings->findings[i];
        for (int v = 0; v < STUDY_VIEWS && f->drawn; v++) {
            const MeasuredErrors *e = &f->views[v];
            write_names(file, findings, f);
            fprintf(file, "%d,%.8f,%.8f,%.5f,%.8f,%.8f,%.8f,", v, finding_error(e), finding_interior_error(e),
                    e->off, e->rmse, e->flip, e->center);
            write_motion(file, findings, f, e);
        }
    }
}

void findings_csv_lines_head(FILE *file) {
    fputs("scene,line,floor,error,interior_error,edge_off_pixels,rmse,flip,worst_interior,worst_off_pixels,"
          "most_interior,most_off_pixels\n",
          file);
}

void findings_csv_lines_write(FILE *file, const SceneFindings *findings) {
    for (int i = 0; i < findings->lines.count; i++) {
        const Baseline *line = &findings->lines.lines[i];
        const MeasuredErrors *e = &line->errors;
        fprintf(file, "%s,%s,%d,%.8f,%.8f,%.5f,%.8f,%.8f,%.8f,%.5f,%.8f,%.5f\n", findings->scene->name,
                line->name, line->is_floor, finding_error(e), finding_interior_error(e), e->off, e->rmse,
                e->flip, line->worst_inside, line->worst_off, findings->scene->tolerance,
                findings->scene->edges ? FINDING_MOST_OFF : 0);
    }
}
