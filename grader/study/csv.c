#include "study/csv.h"

#include "scene/check.h"

#include <string.h>

void csv_head(FILE *file) {
    fputs("scene,lab,whose,method,setting,frames,ms,ms_mad,prepare_ms,prepare_mad,shade_ms,shade_mad,error,"
          "false_shadow,"
          "false_light,edge_false_shadow,edge_false_light,interior_false_shadow,interior_false_light,edge_"
          "off_pixels,"
          "taps,texels,fragments,rays,on_front,enough,chosen\n",
          file);
}

static void write_errors(FILE *file, const MeasuredErrors *e) {
    fprintf(file, "%.8f,%.8f,%.8f,%.8f,%.8f,%.8f,%.8f,%.5f,", finding_error(e),
            e->edge_false_shadow + e->interior_false_shadow, e->edge_false_light + e->interior_false_light,
            e->edge_false_shadow, e->edge_false_light, e->interior_false_shadow, e->interior_false_light,
            e->off);
}

void csv_write(FILE *file, const SceneFindings *findings) {
    for (int i = 0; i < findings->count; i++) {
        const Finding *f = &findings->findings[i];
        const Point *point = &findings->points[i];
        if (!f->drawn)
            continue;
        fprintf(file, "%s,%s,%s,\"%s\",\"%s\",", findings->scene->name, f->method.lab,
                f->method.submission ? "submission" : "ours", f->method.family, f->method.name);
        fprintf(file, "%d,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,", f->frames, point->ms, point->mad, f->prepare_ms,
                f->prepare_mad, f->shade_ms, f->shade_mad);
        write_errors(file, &f->errors);
        fprintf(file, "%.2f,%.0f,%.0f,%.0f,%d,%d,%d\n", f->cost.taps, f->cost.texels, f->cost.fragments,
                f->cost.rays, point->on_front, f->enough, f->chosen);
    }
}
