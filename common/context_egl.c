// EGL without a surface: by the surfaceless platform (Mesa, and what knows it), or else by the platform of
// devices, which drivers of other makers have. glad opens libEGL at run time.
#include "context_routes.h"

#include "scene/check.h"

#include <glad/egl.h>

#include "gl.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_DEVICES = 16, SURFACELESS = -1 };

static EGLDisplay display;
static EGLContext context;
static char route[32];
static char reason[160]; // why the last display did not serve

// NULL: there is no such function.
static void *function(const char *name) {
    void *address;
    __eglMustCastToProperFunctionPointerType found = eglGetProcAddress(name);
    memcpy(&address, &found, sizeof address);
    return address;
}

static bool has_client_extension(const char *name) {
    const char *all = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    return all && strstr(all, name);
}

// By the function of EGL 1.5, or by that of EGL_EXT_platform_base.
static EGLDisplay get_display(EGLenum platform, void *device) {
    PFNEGLGETPLATFORMDISPLAYPROC get;
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_ext;
    void *found = function("eglGetPlatformDisplay"), *found_ext = function("eglGetPlatformDisplayEXT");
    memcpy(&get, &found, sizeof get);
    memcpy(&get_ext, &found_ext, sizeof get_ext);
    EGLDisplay made = get ? get(platform, device, NULL) : EGL_NO_DISPLAY;
    return made == EGL_NO_DISPLAY && get_ext ? get_ext(platform, device, NULL) : made;
}

static int list_devices(EGLDeviceEXT devices[MOST_DEVICES]) {
    PFNEGLQUERYDEVICESEXTPROC query;
    EGLint count = 0;
    void *found = function("eglQueryDevicesEXT");
    memcpy(&query, &found, sizeof query);
    return query && query(MOST_DEVICES, devices, &count) ? count : 0;
}

static bool create_context(void) {
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 1,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    eglBindAPI(EGL_OPENGL_API);
    context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

// The context of one display, current; nothing is left when it does not serve.
static bool try_display(EGLDisplay candidate, const char *name) {
    EGLint major = 0, minor = 0;
    display = candidate;
    snprintf(route, sizeof route, "%s", name);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor)) {
        snprintf(reason, sizeof reason, "%s: no display (error 0x%x)", name, (unsigned)eglGetError());
        return false;
    }
    if (gladLoaderLoadEGL(display) && create_context())
        return true;
    snprintf(reason, sizeof reason, "%s: EGL %d.%d has no OpenGL 4.1 core context (error 0x%x)", name, major,
             minor, (unsigned)eglGetError());
    context_egl_destroy();
    return false;
}

static bool is_software(void) {
    PFNGLGETSTRINGPROC get_string;
    void *found = function("glGetString");
    memcpy(&get_string, &found, sizeof get_string);
    const char *renderer = get_string ? (const char *)get_string(GL_RENDERER) : NULL;
    return renderer && (strstr(renderer, "llvmpipe") || strstr(renderer, "softpipe"));
}

// SURFACELESS or the number of a device.
static bool try_route(int which, const EGLDeviceEXT *devices, bool wants_hardware) {
    char name[32];
    const bool surfaceless = which == SURFACELESS;
    if (surfaceless && !has_client_extension("EGL_MESA_platform_surfaceless"))
        return false;
    snprintf(name, sizeof name, surfaceless ? "EGL surfaceless" : "EGL device %d", which);
    if (!try_display(surfaceless ? get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY)
                                 : get_display(EGL_PLATFORM_DEVICE_EXT, devices[which]),
                     name))
        return false;
    if (!wants_hardware || !is_software())
        return true;
    context_egl_destroy();
    return false;
}

// One device that the user chose by SHADOW_LAB_EGL_DEVICE=N, whatever draws there; no other is tried.
static bool try_chosen(const char *chosen, const EGLDeviceEXT *devices, int count) {
    char *end;
    const long which = strtol(chosen, &end, 10);
    if (*end || end == chosen || which < 0 || which >= count)
        return check_fail("SHADOW_LAB_EGL_DEVICE is \"%s\"; EGL lists %d devices, from 0 on", chosen, count);
    return try_route((int)which, devices, false) || check_fail("%s", reason);
}

bool context_egl_create(void) {
    const char *chosen = getenv("SHADOW_LAB_EGL_DEVICE");
    EGLDeviceEXT devices[MOST_DEVICES];
    if (!gladLoaderLoadEGL(EGL_NO_DISPLAY))
        return check_fail(
            "EGL is not installed; install libegl1 and libgl1-mesa-dri or choose --context osmesa");
    const int count = list_devices(devices);
    if (chosen)
        return try_chosen(chosen, devices, count) && gl_load((GLADloadfunc)eglGetProcAddress);
    // Where a GPU may draw, a renderer on the processor is the last resort.
    for (int wants_hardware = !getenv("LIBGL_ALWAYS_SOFTWARE"); wants_hardware >= 0; wants_hardware--)
        for (int i = SURFACELESS; i < count; i++)
            if (try_route(i, devices, wants_hardware))
                return gl_load((GLADloadfunc)eglGetProcAddress);
    return check_fail("EGL has neither a surfaceless display nor a device that serves (%s); install "
                      "libgl1-mesa-dri or choose --context osmesa",
                      reason[0] ? reason : "it lists no device");
}

const char *context_egl_route(void) {
    return route;
}

void context_egl_destroy(void) {
    if (display == EGL_NO_DISPLAY)
        return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context)
        eglDestroyContext(display, context);
    eglTerminate(display);
    context = EGL_NO_CONTEXT;
    display = EGL_NO_DISPLAY;
}
