#include "stability/probe.h"

#include "truth/closed_scenes.h"

#include <math.h>
#include <string.h>

bool probe_begin(Probe *probe, Bench *bench, const char *lab, const Scene *scene, int width, int height) {
    const TruthQuery query = {.kind = TRUTH_LIGHT};
    *probe = (Probe){.bench = bench, .lab = lab};
    probe->setting = (Setting){.view = VIEW_VISIBILITY, .object = TRUTH_NONE};
    Artist *artist = bench_artist(bench, lab, NULL);
    return artist && ground_create(&probe->ground, scene, (MetricsSize){width, height}, &query, artist);
}

void probe_end(Probe *probe) {
    measured_destroy(&probe->measured);
    ground_destroy(&probe->ground);
    *probe = (Probe){0};
}

void probe_knob(Probe *probe, const char *name, double value) {
    for (int i = 0; i < probe->setting.knob_count; i++)
        if (strcmp(probe->setting.knobs[i].name, name) == 0) {
            probe->setting.knobs[i].value = (float)value;
            return;
        }
    setting_knob(&probe->setting, name, (float)value);
}

bool probe_draw(Probe *probe) {
    Artist *artist = bench_artist(probe->bench, probe->lab, probe->change);
    measured_destroy(&probe->measured);
    return artist && ground_measure(&probe->ground, artist, &probe->setting, false, &probe->measured);
}

double probe_unit(const Probe *probe) {
    return hand_unit(&probe->ground.truth.scene, probe->ground.size.height);
}

double probe_false(const Probe *probe, int object, int sign) {
    double sum = 0, count = 0;
    size_t pixels = (size_t)probe->ground.size.width * (size_t)probe->ground.size.height;
    for (size_t i = 0; i < pixels; i++) {
        double truth = probe->ground.visibility[i];
        if (!probe->measured.mask[i] || probe->ground.picture.hits[i].object != object ||
            truth != (sign < 0 ? 1 : 0) || probe->ground.distance[i] <= METRICS_LEAST_EDGE)
            continue;
        sum += sign * (probe->measured.visibility[i] - truth);
        count++;
    }
    return sum / count;
}
