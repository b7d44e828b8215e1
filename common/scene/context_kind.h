// The headless routes by name. No GL.
#pragma once

#include <stdbool.h>

typedef enum ContextKind {
    CONTEXT_ANY,    // nobody asks for one: the first of the others that is installed (base/context_choice.h)
    CONTEXT_OSMESA, // Mesa's off-screen library
    CONTEXT_EGL,    // EGL without a surface, for systems that no longer ship OSMesa
    CONTEXT_COUNT
} ContextKind;

// "osmesa" or "egl"; false with a message for another name.
bool context_parse(ContextKind *kind, const char *name);
const char *context_name(ContextKind kind); // of CONTEXT_ANY: "any"
