// Where the method of this lab breaks, swept, and held against a closed form.
#include "stability/probe.h"
#include "stability/row.h"
#include "truth/closed_scenes.h"

enum { SIDE = 64 };

// A bare wall in the light: nothing is in shadow, at any distance of the lamp.
static bool run_wall(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "A bare wall", "distance of the lamp (units)", "mean error");
    Curve *curve = figure_curve(figure, "no shadow", CURVE_EQUAL);
    bool ok = true;
    for (int distance = 4; ok && distance <= 12; distance += 4) {
        Scene scene = closed_wall(2, 10, 2 * atanf(0.1F));
        Probe probe;
        closed_light(&scene, LIGHT_SPOT, vec3_make(0, 0, (float)distance), vec3_make(0, 0, 0), 1, 0, 1, 20);
        ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE) && probe_draw(&probe);
        if (ok)
            curve_add(curve, distance, probe.measured.metrics.all.mae, 0, 1e-6);
        probe_end(&probe);
    }
    return ok;
}

const Row LAB_TABLE[] = {
    {100 * LAB_NUMBER + 1, "@NAME@", "say which method", "the distance of the lamp from 4 to 12 units",
     "Say what comes out, and why.", "closed form", run_wall},
    {0},
};
