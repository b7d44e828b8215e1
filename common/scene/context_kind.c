#include "scene/context_kind.h"

#include "scene/check.h"

#include <string.h>

static const char *const names[CONTEXT_COUNT] = {"any", "osmesa", "egl"};

bool context_parse(ContextKind *kind, const char *name) {
    for (int i = CONTEXT_OSMESA; i < CONTEXT_COUNT; i++)
        if (strcmp(names[i], name) == 0) {
            *kind = (ContextKind)i;
            return true;
        }
    return check_fail("there is no context \"%s\"; choose osmesa or egl", name);
}

const char *context_name(ContextKind kind) {
    return names[kind];
}
