#include "stability/probe.h"

#include "truth/closed_scenes.h"

#include <math.h>
#include <string.h>

enum { PROBE_SAMPLES = 256 }; // for a lamp with an extent; others need none

bool probe_begin(Probe *probe, LabSet *labs, const char *lab, const Scene *scene, int width, int height) {
    TruthKind kind = scene->medium.scattering > 0 ? TRUTH_DUST : TRUTH_LIGHT;
    const TruthQuery query = {.kind = kind, .samples = PROBE_SAMPLES, .seed = 1};
    *probe = (Probe){.labs = labs, .lab = lab};
    probe->setting = (Setting){.view = VIEW_VISIBILITY, .object = TRUTH_NONE};
    LabArtist *artist = lab_set_artist(labs, lab, NULL);
    return artist &&
           truth_view_create(&probe->truth_view, scene, (MetricsSize){width, height}, &query, artist);
}

void probe_end(Probe *probe) {
    measured_destroy(&probe->measured);
    truth_view_destroy(&probe->truth_view);
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
    LabArtist *artist = lab_set_artist(probe->labs, probe->lab, probe->change);
    measured_destroy(&probe->measured);
    return artist && truth_view_measure(&probe->truth_view, artist, &probe->setting, false, &probe->measured);
}

double probe_unit(const Probe *probe) {
    return closed_unit(&probe->truth_view.truth.scene, probe->truth_view.size.height);
}

double probe_false(const Probe *probe, int object, int sign) {
    double sum = 0, count = 0;
    size_t pixels = (size_t)probe->truth_view.size.width * (size_t)probe->truth_view.size.height;
    for (size_t i = 0; i < pixels; i++) {
        double truth = probe->truth_view.visibility[i];
        if (!probe->measured.mask[i] || probe->truth_view.picture.hits[i].object != object ||
            truth != (sign < 0 ? 1 : 0) || probe->truth_view.distance[i] <= METRICS_LEAST_EDGE)
            continue;
        sum += sign * (probe->measured.visibility[i] - truth);
        count++;
    }
    return sum / count;
}
