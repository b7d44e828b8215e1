// The routes behind context.h. Each create returns false with a message that names the missing package.
#pragma once

#include <stdbool.h>

// OSMesa, by dlopen.
bool context_osmesa_create(void);
void context_osmesa_destroy(void);

// EGL without a surface, by glad's loader.
bool context_egl_create(void);
void context_egl_destroy(void);
