// EGL without a surface (EGL_MESA_platform_surfaceless). glad opens libEGL at run time.
#include "context_routes.h"

#include "scene/check.h"

#include <glad/egl.h>

#include "gl.h"

static EGLDisplay display;
static EGLContext context;

static bool open_display(void) {
    if (!gladLoaderLoadEGL(EGL_NO_DISPLAY))
        return check_fail(
            "EGL is not installed; install libegl1 and libgl1-mesa-dri or choose --context osmesa");
    // Without a display glad knows the version only as 1.0 and leaves this function of 1.5 out.
    PFNEGLGETPLATFORMDISPLAYPROC get_display =
        (PFNEGLGETPLATFORMDISPLAYPROC)eglGetProcAddress("eglGetPlatformDisplay");
    display =
        get_display ? get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL) : EGL_NO_DISPLAY;
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL) || !gladLoaderLoadEGL(display))
        return check_fail(
            "EGL has no surfaceless display; install libgl1-mesa-dri or choose --context osmesa");
    return true;
}

bool context_egl_create(void) {
    if (!open_display())
        return false;
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 1,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    eglBindAPI(EGL_OPENGL_API);
    context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
        return check_fail("EGL has no OpenGL 4.1 core context (error 0x%x)", (unsigned)eglGetError());
    return gl_load((GLADloadfunc)eglGetProcAddress);
}

void context_egl_destroy(void) {
    if (!context)
        return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    eglTerminate(display);
    context = EGL_NO_CONTEXT;
}
