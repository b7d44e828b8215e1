#include "rows_counting.h"

#include <math.h>

bool counting_begin(Probe *probe, const Counting *counting, const Scene *scene) {
    bool ok = probe_begin(probe, counting->labs, LAB_ID, scene, COUNTING_SIZE, COUNTING_SIZE);
    probe->change = counting->change;
    probe_knob(probe, "method", counting->method != Z_PASS);
    probe_knob(probe, "silhouettes", counting->method == Z_FAIL_CPU);
    return ok && probe_draw(probe);
}

void counting_frame(const Counting *counting, const Probe *probe, double x, double badness) {
    findings_frame(counting->findings, counting->slot, badness, &probe->truth_view, &probe->measured,
                   "%s, at %g in the figure", counting->curve->name, x);
}

void counting_add(const Counting *counting, const Probe *probe, double x, SightShare expected,
                  double fragile) {
    double wrong = probe->measured.metrics.all.mae;
    curve_add(counting->curve, x, wrong, expected.share, expected.tolerance);
    counting_frame(counting, probe, x, fmax(wrong, fragile));
}
