#include "study/cost_chart.h"

#include "study/chart_svg.h"
#include "study/verdict.h"

// The same findings with the counted cost a pixel in the place of times, and without rays; judged by it.
static void put_costs_for_times(const SceneFindings *findings, SceneFindings *made) {
    const double pixels = (double)findings->size.width * findings->size.height;
    *made = *findings;
    made->count = 0;
    for (int i = 0; i < findings->count; i++) {
        if (findings->findings[i].method.rays > 0)
            continue;
        Point point = findings->points[i];
        point.mad = 0;
        point.ms = point.ms < 0 ? point.ms : findings->findings[i].cost.counted / pixels;
        made->findings[made->count] = findings->findings[i];
        made->points[made->count++] = point;
    }
    findings_judge(made);
}

bool cost_chart(const SceneFindings *findings, const char *folder) {
    static SceneFindings made;
    put_costs_for_times(findings, &made);
    return chart_draw(&made, CHART_COST, folder);
}
