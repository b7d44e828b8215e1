// One method in one setting, as the study draws it: a point of the chart.
#pragma once

#include "study/truth_view.h"

#include <stdbool.h>

enum { METHOD_NAME = 48, METHOD_MOST = 160 };

#define METHOD_RAYS "rays" // in the place of a lab: ray tracing itself
#define METHOD_BARE                                                                                          \
    "no shadow" // the family of a frame without any: what all others cost beyond it is their shadow
#define METHOD_NO_EDGE 1e-3F // a width of the edge that no pixel has: the boundary begins at half a pixel

// What a frame costs on any machine: what is counted while it is drawn, and what the setting says of what no
// counter sees.
typedef struct Cost {
    double taps;      // counted: reads of textures, a pixel of the picture
    double fragments; // counted: all that are shaded, of maps, volumes and the picture
    double texels;    // counted: that a clear writes; and those of a bake's atlas
    double atlas;     // texels that a bake fills
    double rays;      // of a bake
    double held;      // bytes of maps and atlases
    double bytes;     // those and what is as large as the picture, without the picture itself
    double counted;   // one number for all of them, by the weights in cost.c
} Cost;

typedef struct Method {
    const char *lab;        // whose passes draw it: "05"
    const char *family;     // a colour of the chart: "box PCF"
    char name[METHOD_NAME]; // the setting, without quotes: "32 samples, 1024 x 1024"
    Setting setting;
    const Change *change; // the lab with a choice fixed when it is built, static; NULL: the lab as it is
    int map_size;         // texels along a side; 0: no shadow map
    float kernel;         // farthest tap from the point, texels
    int maps;             // of that size
    int map_bytes;        // of a texel; 0: as the knob "depth format" says, and 4 where there is none
    int picture_bytes;    // a pixel, of textures that the method keeps as large as the picture
    int texel_bytes;      // of the atlas
    bool by_processor;    // what comes before the picture is worked out without the GPU, as a bake's rays are
    // Adds what a bake costs: its atlas and its rays. NULL: nothing.
    void (*add_cost)(Cost *cost, const struct Method *method, const Scene *scene);
    int rays; // a pixel, of ray tracing; 0: a lab draws
    bool submission;
} Method;

typedef struct MethodList {
    Method methods[METHOD_MOST];
    int count;
} MethodList;

// Adds a setting of `family` in lab `lab` to the list, seen in the visibility view; `format` is its name.
Method *method_add(MethodList *list, const char *lab, const char *family, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

// The same for a method with a shadow map; the map's size becomes a knob and the end of the name.
Method *method_add_map(MethodList *list, const char *lab, const char *family, int map_size,
                       const char *format, ...) __attribute__((format(printf, 5, 6)));

// A knob of the setting; `other` where the setting leaves it alone.
float method_knob(const Method *method, const char *name, float other);
