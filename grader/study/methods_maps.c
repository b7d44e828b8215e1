// The settings of the labs with shadow maps, 03 to 06.
#include "study/method.h"
#include "study/study_scenes.h"
#include "scene/count.h"

#include <stdio.h>

static const int sizes[] = {256, 512, 1024, 2048, 4096};
enum { SIZES = COUNT(sizes) };

// Values of the knob "method" of lab 04.
enum { NONE, CONSTANT, SLOPE, OFFSET, FACES, NORMAL };

// `format` names the knob's value.
static Setting *add_bias(MethodList *list, int size, const char *family, int method, const char *knob,
                         float value, const char *format) {
    char name[METHOD_NAME];
    snprintf(name, sizeof name, format, (double)value);
    Setting *setting = &method_add_map(list, "04", family, size, "%s", name)->setting;
    setting_knob(setting, "method", (float)method);
    if (knob)
        setting_knob(setting, knob, value);
    return setting;
}

static void add_biases(MethodList *list, int size) {
    add_bias(list, size, "no bias", NONE, NULL, 0, "");
    add_bias(list, size, "constant bias", CONSTANT, "bias", 0.002f, "bias %g");
    add_bias(list, size, "constant bias", CONSTANT, "bias", 0.01f, "bias %g");
    Setting *slope = add_bias(list, size, "slope bias", SLOPE, "slope bias", 0.03f, "slope bias %g");
    setting_knob(slope, "bias", 0.001f);
    add_bias(list, size, "polygon offset", OFFSET, "factor", 1, "factor %g");
    add_bias(list, size, "polygon offset", OFFSET, "factor", 2, "factor %g");
    add_bias(list, size, "front faces culled", FACES, NULL, 0, "");
    add_bias(list, size, "normal offset", NORMAL, "normal offset", 0.5f, "%g texels");
    add_bias(list, size, "normal offset", NORMAL, "normal offset", 1, "%g texel");
}

void methods_of_bias(MethodList *list) {
    for (int i = 0; i < SIZES; i++)
        add_biases(list, sizes[i]);
    for (int bits = 16; bits <= 32; bits += 16) {
        Setting *setting =
            add_bias(list, 1024, "polygon offset", OFFSET, "factor", 2,
                     bits == 16 ? "factor %g, 16 bits of depth" : "factor %g, 32 bits of depth");
        setting_knob(setting, "depth format", (float)bits);
    }
}

typedef struct Filter {
    const char *family;
    int method, radius, taps; // knobs of lab 05; lookups a pixel
    float kernel;
} Filter;

static const Filter hard = {"hard", 0, 0, 1, 0}, by_hand = {"3 x 3 by hand", 1, 0, 9, 1},
                    linear = {"linear", 2, 0, 1, 0}, diagonals = {"4 diagonals", 3, 0, 4, 1},
                    box_5 = {"box 5 x 5", 4, 2, 25, 2}, gather = {"3 x 3 by gathers", 5, 0, 4, 1};

// llvmpipe walks all branches of a shader, whatever a uniform chooses, so each filter is measured in a shader
// in which the choice is fixed, as a course or a game would build it.
#define FIX(method)                                                                                          \
    {                                                                                                        \
        .name = "method " #method " fixed",                                                                  \
        .edits = {{"shadow.frag", "uniform int u_method;", "const int u_method = " #method ";"}},            \
        .edit_count = 1                                                                                      \
    }
static const Change fixed[] = {FIX(0), FIX(1), FIX(2), FIX(3), FIX(4), FIX(5)};

static void add_filter(MethodList *list, Filter filter, int size) {
    Method *method = method_add_map(list, "05", filter.family, size, "%s", "");
    setting_knob(&method->setting, "method", (float)filter.method);
    method->change = &fixed[filter.method];
    if (filter.radius > 0)
        setting_knob(&method->setting, "kernel radius", (float)filter.radius);
    method->taps = filter.taps;
    method->kernel = filter.kernel;
}

void methods_of_edges(MethodList *list) {
    const Filter filters[] = {hard, by_hand, linear, diagonals, box_5, gather};
    for (int i = 0; i < SIZES; i++) {
        method_add_map(list, "03", "basic map", sizes[i], "%s", "");
        for (unsigned f = 0; f < COUNT(filters); f++)
            add_filter(list, filters[f], sizes[i]);
    }
}

// Random samples in a disc of `radius` texels; `wide` says by how much that is not the matched one.
static void add_random(MethodList *list, int size, int columns, int rows, bool early_out, float wide) {
    int samples = columns * rows;
    Method *method =
        method_add_map(list, "06", early_out ? "random with early-out" : "random", size,
                       wide == 1 ? "%d samples" : "%d samples, radius x %g", samples, (double)wide);
    setting_knob(&method->setting, "columns", (float)columns);
    setting_knob(&method->setting, "rows", (float)rows);
    setting_knob(&method->setting, "radius", wide * (float)size / SCENES_KERNEL);
    setting_knob(&method->setting, "early-out", early_out);
    method->taps = samples;
    method->first = early_out ? 8 : 0;
    method->kernel = wide * (float)size / SCENES_KERNEL;
}

static void add_box(MethodList *list, int size) {
    int radius = size / SCENES_KERNEL, side = 2 * radius + 1;
    Method *method = method_add_map(list, "05", "box PCF", size, "%d x %d", side, side);
    setting_knob(&method->setting, "method", 4);
    method->change = &fixed[4];
    setting_knob(&method->setting, "kernel radius", (float)radius);
    method->taps = side * side;
    method->kernel = (float)radius;
}

void methods_of_penumbra(MethodList *list) {
    const int grids[][2] = {{4, 2}, {4, 4}, {4, 8}, {8, 8}, {16, 16}};
    add_filter(list, hard, 1024);
    add_filter(list, linear, 256);
    for (int size = 128; size <= 512; size *= 2)
        add_box(list, size);
    for (int size = 256; size <= 1024; size *= 4)
        for (int grid = 0; grid < 5; grid++)
            for (int early_out = 0; early_out < (grid > 0 ? 2 : 1); early_out++)
                add_random(list, size, grids[grid][0], grids[grid][1], early_out, 1);
    add_random(list, 512, 4, 8, true, 1);
    add_random(list, 2048, 4, 8, true, 1);
    add_random(list, 4096, 4, 8, true, 1);
    add_random(list, 1024, 4, 8, true, 0.5f);
    add_random(list, 1024, 4, 8, true, 2);
}

void methods_of_volumes(MethodList *list) {
    const Filter filters[] = {linear, gather};
    for (int i = 0; i < SIZES; i++) {
        method_add_map(list, "03", "basic map", sizes[i], "%s", "");
        for (unsigned f = 0; f < COUNT(filters); f++)
            add_filter(list, filters[f], sizes[i]);
    }
    for (int z_fail = 0; z_fail < 2; z_fail++)
        for (int on_cpu = 0; on_cpu < 2; on_cpu++) {
            Method *method = method_add(list, "07", z_fail ? "z-fail volumes" : "z-pass volumes", "%s",
                                        on_cpu ? "silhouettes on the CPU" : "geometry shader");
            setting_knob(&method->setting, "method", (float)z_fail);
            setting_knob(&method->setting, "silhouettes", (float)on_cpu);
            method->volumes = true;
            method->taps = 0;
        }
}
