// OSMesa is opened with dlopen and needs four functions. Its few constants are spelled out here (values of
// GL/osmesa.h), so that the project also builds where Mesa no longer ships the header.
#include "context_routes.h"

#include "scene/check.h"
#include "gl.h"

#include <dlfcn.h>
#include <stddef.h>
#include <string.h>

enum {
    OSMESA_FORMAT = 0x22,
    OSMESA_DEPTH_BITS = 0x30,
    OSMESA_PROFILE = 0x33,
    OSMESA_CORE_PROFILE = 0x34,
    OSMESA_CONTEXT_MAJOR_VERSION = 0x36,
    OSMESA_CONTEXT_MINOR_VERSION = 0x37
};

typedef void *(*CreateContext)(const int *attributes, void *shared);
typedef unsigned char (*MakeCurrent)(void *context, void *buffer, GLenum type, GLsizei width, GLsizei height);
typedef void (*DestroyContext)(void *context);

static void *library, *context;
static DestroyContext destroy_context;
static unsigned char pixel[4];

// ISO C has no cast from an object pointer to a function pointer: copy the bits.
static bool find(void *function, const char *name) {
    void *symbol = dlsym(library, name);
    memcpy(function, &symbol, sizeof symbol);
    return symbol || check_fail("libOSMesa lacks %s; install a newer libosmesa6", name);
}

bool context_osmesa_create(void) {
    CreateContext create;
    MakeCurrent make_current;
    GLADloadfunc load;
    library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (!library)
        library = dlopen("libOSMesa.so", RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return check_fail("OSMesa is not installed (%s); install libosmesa6 or choose --context egl",
                          dlerror());
    if (!find(&create, "OSMesaCreateContextAttribs") || !find(&make_current, "OSMesaMakeCurrent") ||
        !find(&load, "OSMesaGetProcAddress") || !find(&destroy_context, "OSMesaDestroyContext"))
        return false;
    const int attributes[] = {OSMESA_FORMAT,
                              GL_RGBA,
                              OSMESA_DEPTH_BITS,
                              0,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              4,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              1,
                              0};
    context = create(attributes, NULL);
    if (!context || !make_current(context, pixel, GL_UNSIGNED_BYTE, 1, 1))
        return check_fail("OSMesa has no OpenGL 4.1 core context; is GALLIUM_DRIVER set to another driver?");
    return gl_load(load);
}

void context_osmesa_destroy(void) {
    if (context)
        destroy_context(context);
    context = NULL;
}
