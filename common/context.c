#include "context.h"

#include "context_routes.h"

static const struct {
    bool (*create)(void);
    void (*destroy)(void);
} routes[CONTEXT_COUNT] = {
    [CONTEXT_OSMESA] = {context_osmesa_create, context_osmesa_destroy},
    [CONTEXT_EGL] = {context_egl_create, context_egl_destroy},
};

bool context_create(ContextKind kind) {
    return routes[kind].create();
}

const char *context_route(ContextKind kind) {
    return kind == CONTEXT_EGL ? context_egl_route() : "OSMesa";
}

void context_destroy(void) {
    for (int kind = CONTEXT_OSMESA; kind < CONTEXT_COUNT; kind++)
        routes[kind].destroy();
}
