#include "base/context_choice.h"

#include "base/installed.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>

static bool has_osmesa(void) {
    return installed_library("libOSMesa.so.8") || installed_library("libOSMesa.so");
}

// By the environment; false when it asks for nothing. *ok: it asks for what there is.
static bool is_asked_for(ContextKind *kind, bool *ok) {
    const char *text = getenv("SHADOW_LAB_CONTEXT");
    if (!text || !text[0])
        return false;
    *ok = context_parse(kind, text);
    if (!*ok) {
        check_clear();
        check_fail("SHADOW_LAB_CONTEXT is osmesa or egl, not \"%s\"", text);
    }
    return true;
}

bool context_choose(ContextKind *kind) {
    static ContextKind found; // looked for once
    bool ok = true;
    if (*kind != CONTEXT_ANY || is_asked_for(kind, &ok))
        return ok;
    if (found == CONTEXT_ANY)
        found = has_osmesa() ? CONTEXT_OSMESA : CONTEXT_EGL;
    *kind = found;
    return true;
}

bool context_choose_aloud(ContextKind *kind, const char *program) {
    const char *asked = getenv("SHADOW_LAB_CONTEXT");
    const bool open = *kind == CONTEXT_ANY && (!asked || !asked[0]);
    if (!context_choose(kind))
        return false;
    if (open && *kind == CONTEXT_EGL)
        fprintf(stderr, "%s: there is no OSMesa here: EGL draws\n", program);
    return true;
}
