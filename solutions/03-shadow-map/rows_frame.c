// Where the map ends: its sides, its far plane, and what lies behind the light.
#include "truth/closed_scenes.h"
#include "stability/probe.h"
#include "stability/row.h"

enum { SIDE = 200 };

// A wall and light straight on. The map is 2 half_size wide, the picture shows just the wall.
static Scene straight(float wall, float half_size, float far_plane) {
    const float distance = 20;
    Scene scene = closed_wall(wall, distance, 2 * atanf(wall / distance));
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(0, 0, 8), vec3_make(0, 0, 0), 0, half_size, 1,
                 far_plane);
    return scene;
}

// Of a map that repeats: how much of [-reach, reach] lies in [-half, half] + period * n for any n.
static double repeated(double half, double period, double reach) {
    double sum = 0;
    for (int n = -8; n <= 8; n++)
        sum += fmax(fmin(n * period + half, reach) - fmax(n * period - half, -reach), 0);
    return sum;
}

// False shadow on the wall outside the map's frame, as a share of what lies there.
static double outside_shadow(const Probe *probe, double half_size) {
    double dark = 0, count = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        const TruthHit *hit = &probe->truth_view.picture.hits[i];
        if (hit->object != 0 || fmaxf(fabsf(hit->position.x), fabsf(hit->position.y)) < half_size)
            continue;
        dark += 1 - probe->measured.visibility[i];
        count++;
    }
    return dark / count;
}

static bool sweep_floor(LabSet *labs, Findings *findings, Curve *curve, const char *mistake) {
    const double half = 1, caster = 0.4, texel = 2 * half / 256;
    LabArtist *artist = lab_set_artist(labs, LAB_ID, NULL);
    const Change *change = artist && mistake ? rubric_mistake(&artist->rubric, mistake) : NULL;
    bool ok = artist && (change || !mistake);
    for (int i = 0; ok && i <= 6; i++) {
        double wall = half * (1.5 + 0.25 * i), unit = 2 * wall / SIDE;
        Scene scene = straight((float)wall, (float)half, 10);
        closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, 1), vec3_make((float)caster, (float)caster, 0.01F), 0);
        Probe probe;
        ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE);
        probe.change = change;
        probe_knob(&probe, "map size", 256);
        ok = ok && probe_draw(&probe);
        if (ok) {
            double length = repeated(caster, 2 * half, wall), outside = 4 * (wall * wall - half * half);
            double dark = outside_shadow(&probe, half), ends = 4 * length * (texel / 2 + unit / 2) * 2;
            curve_add(curve, wall / half, dark,
                      mistake ? (length * length - 4 * caster * caster) / outside : 0,
                      mistake ? ends / outside : 0);
            findings_frame(findings, 0, dark, &probe.truth_view, &probe.measured,
                           "The wall is %.2f times as wide as the map", wall / half);
        }
        probe_end(&probe);
    }
    return ok;
}

static bool run_frame(LabSet *labs, Findings *findings) {
    Figure *figure =
        findings_figure(findings, "Outside the map's frame", "width of the wall (widths of the map)",
                        "false shadow (share of what lies outside)");
    return sweep_floor(labs, findings, figure_curve(figure, "failure: GL_REPEAT", CURVE_EQUAL),
                       "the map repeats outside its border") &&
           sweep_floor(labs, findings, figure_curve(figure, "remedy: a border of depth 1", CURVE_EQUAL),
                       NULL);
}

// Lab 05's linear lookup without the guard, with another comparison and another format.
#define UNGUARDED                                                                                            \
    {                                                                                                        \
        "shadow.frag",                                                                                       \
            "    if (!find_in_shadow_map(position_world, position_map, outside))\n        return "           \
            "outside;\n",                                                                                    \
            "    find_in_shadow_map(position_world, position_map, outside);\n"                               \
    }
#define COMPARE(function)                                                                                    \
    { "lab.c", "GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL", "GL_TEXTURE_COMPARE_FUNC, " function }
#define FORMAT(bits)                                                                                         \
    { "lab.c", "GL_DEPTH_COMPONENT24", "GL_DEPTH_COMPONENT" bits }

typedef struct Comparison {
    const char *name;
    Change change;
    double beyond; // false shadow beyond the far plane
} Comparison;

static const Comparison unguarded[] = {
    {"GL_LESS, 16 bits",
     {.name = "less 16", .edits = {UNGUARDED, COMPARE("GL_LESS"), FORMAT("16")}, .edit_count = 3},
     1},
    {"GL_LESS, 24 bits", {.name = "less 24", .edits = {UNGUARDED, COMPARE("GL_LESS")}, .edit_count = 2}, 1},
    {"GL_LESS, 32 bits (float)",
     {.name = "less 32", .edits = {UNGUARDED, COMPARE("GL_LESS"), FORMAT("32F")}, .edit_count = 3},
     1},
    {"GL_LEQUAL, 16 bits", {.name = "lequal 16", .edits = {UNGUARDED, FORMAT("16")}, .edit_count = 2}, 0},
    {"GL_LEQUAL, 24 bits", {.name = "lequal 24", .edits = {UNGUARDED}, .edit_count = 1}, 0},
    {"GL_LEQUAL, 32 bits (float)",
     {.name = "lequal 32", .edits = {UNGUARDED, FORMAT("32F")}, .edit_count = 2},
     1},
};

static const Comparison guarded[] = {
    {"remedy: guard, GL_LESS, 16 bits",
     {.name = "guard less 16", .edits = {COMPARE("GL_LESS"), FORMAT("16")}, .edit_count = 2},
     0},
    {"remedy: guard, GL_LEQUAL, 24 bits", {0}, 0},
    {"remedy: guard, GL_LEQUAL, 32 bits (float)",
     {.name = "guard lequal 32", .edits = {FORMAT("32F")}, .edit_count = 1},
     0},
};

static bool sweep_far(LabSet *labs, Findings *findings, Figure *figure, const Comparison *comparison) {
    enum { LINEAR = 2 };
    static const double places[] = {0.8, 0.99, 1.01, 1.2, 2};
    Curve *curve = figure_curve(figure, comparison->name, CURVE_EQUAL);
    bool ok = true;
    for (int i = 0; ok && i < 5; i++) {
        Scene scene = straight(1, 2, (float)(8 / places[i]));
        Probe probe;
        ok = probe_begin(&probe, labs, "05", &scene, SIDE / 2, SIDE / 2);
        probe.change = comparison->change.name ? &comparison->change : NULL;
        probe_knob(&probe, "method", LINEAR);
        ok = ok && probe_draw(&probe);
        if (ok) {
            double dark = probe.measured.metrics.all.false_shadow;
            curve_add(curve, places[i], dark, places[i] > 1 ? comparison->beyond : 0, 0);
            findings_frame(findings, 0, dark, &probe.truth_view, &probe.measured,
                           "%s, a wall at %.2f of the far plane", comparison->name, places[i]);
        }
        probe_end(&probe);
    }
    return ok;
}

static bool run_far(LabSet *labs, Findings *findings) {
    Figure *without = findings_figure(findings, "No guard", "distance of the wall (far planes)",
                                      "false shadow (share of the wall)");
    Figure *with = findings_figure(findings, "Guard: depth > 1 is lit", "distance of the wall (far planes)",
                                   "false shadow (share of the wall)");
    bool ok = true;
    for (int i = 0; ok && i < 6; i++)
        ok = sweep_far(labs, findings, without, &unguarded[i]);
    for (int i = 0; ok && i < 3; i++)
        ok = sweep_far(labs, findings, with, &guarded[i]);
    return ok;
}

static const Change no_guard_behind = {
    .name = "no test for points behind the light",
    .edits = {{"shadow.frag", "    if (position_light_clip.w <= 0.0)\n        return 0.0;\n", ""}},
    .edit_count = 1};

// A spot light over the wall that looks along it, to the right: the wall to its left is dark.
static bool sweep_lamp(LabSet *labs, Findings *findings, Curve *curve, const Change *change) {
    const float wall = 4;
    bool ok = true;
    for (int i = 0; ok && i <= 6; i++) {
        float x = -3 + (float)i;
        Scene scene = straight(wall, 0, 0);
        scene.lights[0] = (Light){.kind = LIGHT_SPOT,
                                  .position = vec3_make(x, 0, 2),
                                  .target = vec3_make(x + 1, 0, 2),
                                  .color = vec3_make(1, 1, 1),
                                  .fov_y = glm_rad(120),
                                  .near_plane = 0.2F,
                                  .far_plane = 20};
        Probe probe;
        ok = probe_begin(&probe, labs, LAB_ID, &scene, SIDE, SIDE);
        probe.change = change;
        ok = ok && probe_draw(&probe);
        if (ok) {
            double light = probe.measured.metrics.all.false_light,
                   dark = probe.measured.metrics.all.false_shadow;
            double behind = (x + wall) / (2 * wall);
            curve_add(curve, behind, light + dark, change ? behind : 0, change ? 1.0 / SIDE : 0);
            findings_frame(findings, 0, light, &probe.truth_view, &probe.measured,
                           "A lamp over the wall looks to the right, %.0f %% of the wall behind it",
                           100 * behind);
        }
        probe_end(&probe);
    }
    return ok;
}

static bool run_behind(LabSet *labs, Findings *findings) {
    Figure *figure = findings_figure(findings, "A wall that reaches behind the lamp",
                                     "wall behind it (share)", "error (share of the wall)");
    return sweep_lamp(labs, findings, figure_curve(figure, "failure: no test of w", CURVE_EQUAL),
                      &no_guard_behind) &&
           sweep_lamp(labs, findings, figure_curve(figure, "remedy: dark where w <= 0", CURVE_EQUAL), NULL);
}

const Row LAB_TABLE[] = {
    {9, "frame of the map", "shadow map", "the wall's width, 1.5 to 3 times the map's",
     "With GL_REPEAT the shadow in the map comes again in each period: the part of the wall that the "
     "repeated squares cover. With a border of depth 1 nothing outside is dark.",
     "closed form", run_frame},
    {10, "far plane of the map", "shadow map, hardware comparison",
     "the wall's distance across the far plane, by comparison and depth format",
     "Beyond the far plane the reference is greater than 1 and the map is at 1. OpenGL clamps the reference "
     "for the fixed-point formats only: GL_LESS makes all dark, GL_LEQUAL makes it lit with 16 and 24 bits "
     "and dark in floats. A guard in the shader is right for all.",
     "OpenGL 4.1 core, Texture Comparison Modes", run_far},
    {11, "back-projection", "shadow map of a spot light", "how much of the wall lies behind the lamp",
     "Behind the lamp w is negative and the depth after the division greater than 1: without a test of its "
     "own all of it takes the test for the far plane and is lit. The test of w leaves nothing.",
     "closed form; C. Everitt: Projective Texture Mapping, 2001", run_behind},
    {0},
};
