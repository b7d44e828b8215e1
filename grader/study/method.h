// One method in one setting, as the study draws it: a point of the chart.
#pragma once

#include "study/truth_view.h"

#include <stdbool.h>

enum { METHOD_NAME = 48, METHOD_MOST = 160 };

#define METHOD_RAYS "rays" // in the place of a lab: ray tracing itself
#define METHOD_BARE                                                                                          \
    "no shadow" // the family of a frame without any: what all others cost beyond it is their shadow
#define METHOD_NO_EDGE 1e-3F // a width of the edge that no pixel has: the boundary begins at half a pixel

// What a frame costs on any machine, as the setting has it.
typedef struct Cost {
    double taps;      // lookups of a pixel in the map or atlas; with early-out the mean over the picture
    double texels;    // of the map or the atlas
    double fragments; // of the shadow volumes, hidden or not
    double rays;      // of a bake
    double bytes;     // of maps, atlases and what is as large as the picture, without the picture itself
    double counted;   // one number for all of them, by the weights in cost.c: a model
} Cost;

typedef struct Method {
    const char *lab;        // whose passes draw it: "05"
    const char *family;     // a colour of the chart: "box PCF"
    char name[METHOD_NAME]; // the setting, without quotes: "32 samples, 1024 x 1024"
    Setting setting;
    const Change *change; // the lab with a choice fixed when it is built, static; NULL: the lab as it is
    int map_size;         // texels along a side; 0: no shadow map
    float kernel;         // farthest tap from the point, texels
    int taps;             // lookups of a pixel
    int first;            // early-out: the taps after which it may stop; 0: none
    bool volumes;         // draws shadow volumes
    int picture_bytes;    // a pixel, of textures that the method keeps as large as the picture
    int texel_bytes;      // of the atlas; of a map its knob "depth format" says it, and 4 where there is none
    bool by_processor;    // what comes before the picture is worked out without the GPU, as a bake's rays are
    // Adds what only its lab can count to the cost; NULL: nothing.
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
