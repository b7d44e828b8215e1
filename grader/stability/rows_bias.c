// Acne on a bare plane, the cures, and what they cost. The light is directional and tilted from the plane's
// normal, so that closed forms hold: s is the texel of the map, theta the angle between light and normal, psi
// the slope's azimuth in the map, K = |cos psi| + |sin psi|, and the least bias of a nearest lookup b0 = s
// tan(theta) K / 2.
#include "row.h"

#include "check.h"
#include "hand.h"

enum { SIZE = 200 };
static const float NEAR = 4, FAR = 16;

// A wall seen straight on under a light at the angle theta from its normal. psi turns the light about the
// normal (degrees, both); the map's axes stay those of the wall at psi = 0.
static Scene tilted_light(double theta, double psi, float half_size) {
    double t = glm_rad((float)theta), p = glm_rad((float)psi);
    Scene scene = hand_wall(6, 10, glm_rad(40));
    hand_light(
        &scene, LIGHT_DIRECTIONAL,
        vec3_make((float)(-10 * sin(t) * cos(p)), (float)(-10 * sin(t) * sin(p)), (float)(10 * cos(t))),
        vec3_make(0, 0, 0), 0, half_size, NEAR, FAR);
    return scene;
}

static bool run_map(Bench *bench, Findings *findings) {
    Figure *figure =
        findings_figure(findings, "Bare plane, no bias", "map size (texels)", "false shadow (share)");
    figure->log_x = true;
    Curve *curve = figure_curve(figure, "no bias", CURVE_EQUAL);
    const Scene scene = tilted_light(60, 0, 4);
    Artist *artist = bench_artist(bench, "04", NULL);
    Ground ground = {0};
    bool ok = artist && ground_create(&ground, &scene, (MetricsSize){SIZE, SIZE},
                                      &(TruthQuery){.kind = TRUTH_LIGHT}, artist);
    for (int size = 128; ok && size <= 4096; size *= 2) {
        Setting setting = {.view = VIEW_VISIBILITY, .object = TRUTH_NONE};
        Measured measured = {0};
        setting_knob(&setting, "method", 0);
        setting_knob(&setting, "map size", (float)size);
        ok = ground_measure(&ground, artist, &setting, false, &measured);
        if (ok) {
            curve_add(curve, size, measured.metrics.all.false_shadow, 0.5, 0.01);
            findings_frame(findings, 0, fabs(measured.metrics.all.false_shadow - 0.5), &ground, &measured,
                           "Map of %d texels", size);
        }
        measured_destroy(&measured);
    }
    ground_destroy(&ground);
    return ok;
}

const Row rows_bias[] = {
    {1, "map resolution", "shadow map without bias", "map size", "half", "closed form", run_map},
    {0},
};
