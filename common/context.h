// A headless OpenGL 4.1 core context. Each route opens its library at run time, so neither is needed where
// the other serves.
#pragma once

#include "scene/context_kind.h"

// Creates the context, makes it current and loads GL. One per process; there is no default
// framebuffer to draw into.
bool context_create(ContextKind kind);
void context_destroy(void); // harmless when none was created

// By which way the context came: "OSMesa", "EGL surfaceless", "EGL device 0".
const char *context_route(ContextKind kind);
