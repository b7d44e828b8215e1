#include "counting.h"

bool counting_begin(Probe *probe, const Counting *counting, const Scene *scene) {
    bool ok = probe_begin(probe, counting->bench, "07", scene, COUNTING_SIZE, COUNTING_SIZE);
    probe->change = counting->change;
    probe_knob(probe, "method", counting->method);
    return ok && probe_draw(probe);
}

void counting_frame(const Counting *counting, const Probe *probe, double x) {
    findings_frame(counting->findings, counting->slot, probe->measured.metrics.all.mae, &probe->ground,
                   &probe->measured, "%s at %g", counting->curve->name, x);
}

void counting_add(const Counting *counting, const Probe *probe, double x, SightShare expected) {
    curve_add(counting->curve, x, probe->measured.metrics.all.mae, expected.share, expected.tolerance);
    counting_frame(counting, probe, x);
}
