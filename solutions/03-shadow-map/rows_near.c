// Casters before the light's near plane.
#include "truth/closed_scenes.h"
#include "stability/probe.h"
#include "stability/row.h"

enum { SIDE = 200, MAP = 512 };
static const double wall = 1.5, half_width = 0.8, half_height = 0.6, turn = 40, middle = 2, lamp = 8;

// A sheet that stands askew between the light and the camera, which sees the wall alone: its depths, as the
// light sees it, reach from lamp - middle - half_width sin(turn) to as far behind.
static Scene askew(double near_plane) {
    Scene scene = closed_wall((float)wall, 1.2f, (float)(2 * atan(wall / 1.2)));
    scene.camera.near_plane = 0.1f;
    closed_stand(&scene, vec3_make(0, 0, (float)middle), (float)half_width, (float)half_height, (float)turn);
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(0, 0, (float)lamp), vec3_make(0, 0, 0), 0, 2,
                 (float)near_plane, 10);
    return scene;
}

// "Pancaking": what lies before the near plane is kept, at the depth 0.
static const Change clamped = {.name = "casters before the near plane are flattened onto it",
                               .edits = {{"lab.c", "    glPolygonOffset(2, 4);\n",
                                          "    glPolygonOffset(2, 4);\n    glEnable(GL_DEPTH_CLAMP);\n"},
                                         {"lab.c", "    glDisable(GL_POLYGON_OFFSET_FILL);\n",
                                          "    glDisable(GL_POLYGON_OFFSET_FILL);\n"
                                          "    glDisable(GL_DEPTH_CLAMP);\n"}},
                               .edit_count = 2};

static bool sweep(LabSet *labs, Findings *findings, Curve *curve, const Change *change) {
    const double t = closed_radians(turn), first = lamp - middle - half_width * sin(t),
                 depth = 2 * half_width * sin(t), area = 4 * half_width * cos(t) * half_height;
    const double picture = 4 * wall * wall, side = 2 * half_height + 4 * half_width * cos(t);
    const double step = 2.0 * 2 / MAP / 2 + 2 * wall / SIDE / 2; // half a texel and half a pixel
    bool ok = true;
    for (int i = 0; ok && i <= 10; i++) {
        const double cut = -0.2 + 0.14 * i, near_plane = first + cut * depth;
        const Scene scene = askew(near_plane);
        Probe probe;
        ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE);
        probe.change = change;
        probe_knob(&probe, "map size", MAP);
        ok = ok && probe_draw(&probe);
        if (ok) {
            const double light = probe.measured.metrics.all.false_light;
            curve_add(curve, near_plane, light, change ? 0 : fmin(fmax(cut, 0), 1) * area / picture,
                      step * (side + 2 * half_height) / picture);
            findings_frame(findings, 0, light, &probe.truth_view, &probe.measured,
                           "The near plane at %.2f, the sheet from %.2f to %.2f", near_plane, first,
                           first + depth);
        }
        probe_end(&probe);
    }
    return ok;
}

static bool run_near(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "A sheet before the near plane",
                                     "the light's near plane (world units)", "false light (share)");
    return sweep(labs, findings, figure_curve(figure, "failure: cut off", CURVE_EQUAL), NULL) &&
           sweep(labs, findings, figure_curve(figure, "remedy: GL_DEPTH_CLAMP", CURVE_EQUAL), &clamped);
}

const Row LAB_TABLE[] = {
    {43, "casters before the near plane", "shadow map",
     "the light's near plane goes through a sheet that stands askew",
     "What lies before the near plane is cut off and casts nothing: the light's share of the shadow grows "
     "with "
     "the cut, to all of it. With GL_DEPTH_CLAMP while the map is drawn (\"pancaking\") it stays, flattened "
     "onto the plane. The tolerance is half a texel and half a pixel along the edges of shadow and cut.",
     "closed form", run_near},
    {0},
};
