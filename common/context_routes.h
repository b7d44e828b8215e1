// The routes behind context.h. Each create returns false with a message that names the missing package.
#pragma once

#include <stdbool.h>

// OSMesa, by dlopen.
bool context_osmesa_create(void);
void context_osmesa_destroy(void);

// EGL without a surface, by glad's loader: the surfaceless platform first, then the devices in their order. A
// renderer on the processor is taken only where there is no other, or LIBGL_ALWAYS_SOFTWARE is set. With
// SHADOW_LAB_EGL_DEVICE=N only device N is tried.
bool context_egl_create(void);
const char *context_egl_route(void); // "EGL surfaceless", "EGL device 0"
void context_egl_destroy(void);
