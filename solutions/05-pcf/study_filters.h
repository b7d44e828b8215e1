// What this lab's files of the study share: the scene of plates, and filters in shaders of their own.
#pragma once

#include "study/study_scene.h"

#define FASTER "faster edges" // a scene's name

typedef struct Filter {
    const char *family;
    int method, radius; // knobs
    float kernel;       // farthest tap from the point, texels
} Filter;

// Those that more than one scene has.
static const Filter filter_linear = {"linear", 2, 0, 0}, filter_box_5 = {"box 5 x 5", 4, 2, 2},
                    filter_gather = {"3 x 3 by gathers", 5, 0, 1};

// An edit: the choice of the method is a constant of the shader.
#define FILTER_FIXED(method)                                                                                 \
    { "shadow.frag", "uniform int u_method;", "const int u_method = " method ";" }

enum { FILTERS_FIXED = 6 };
extern const Change filters_fixed[FILTERS_FIXED]; // by the number of the method, each with that one edit

// The same filters in less time, each an edit of this lab: the map is kept while nothing moves; it holds what
// casts alone; the box from lookups between texels and from gathers; a tent in the place of the box of 3 x 3.
extern const Change filter_kept, filter_casters, filter_between, filter_gathers, filter_tent;

// Plates before a wall, both square to the light.
void filters_make_edges(Scene *scene);

// Adds the filter with a map of this size, in the shader in which it is fixed.
Method *filters_add(MethodList *list, Filter filter, int size);
