#include "gl.h"

#include "scene/check.h"

#include <dlfcn.h>
#include <execinfo.h>
#include <stdint.h>
#include <string.h>

static char first_error[512];
static bool refused;

static const char *error_name(GLenum error) {
    switch (error) {
    case GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
        return "GL_OUT_OF_MEMORY";
    default:
        return "an unknown GL error";
    }
}

static const char *framebuffer_status(GLenum status) {
    switch (status) {
    case GL_FRAMEBUFFER_COMPLETE:
        return "complete";
    case GL_FRAMEBUFFER_UNDEFINED:
        return "the default framebuffer, which does not exist here: bind frame->framebuffer";
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
        return "GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT: an attachment has no storage or a wrong format";
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
        return "GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT: nothing is attached";
    case GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER:
        return "GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER: a draw buffer names an attachment that is not there";
    case GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER:
        return "GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER: the read buffer names an attachment that is not there";
    case GL_FRAMEBUFFER_UNSUPPORTED:
        return "GL_FRAMEBUFFER_UNSUPPORTED: this combination of formats is not supported";
    default:
        return "incomplete";
    }
}

void gl_append_caller(char *text, size_t size, void *const *frames, int count) {
    for (int i = 0; i < count; i++) {
        Dl_info info;
        if (!dladdr(frames[i], &info) || !info.dli_fname || !strstr(info.dli_fname, "lab.so"))
            continue;
        // A return address points behind its call.
        check_append(text, size, " @0x%lx@",
                     (unsigned long)((uintptr_t)frames[i] - (uintptr_t)info.dli_fbase - 1));
        return;
    }
}

static void before_call(const char *name, GLADapiproc function, int count, ...) {
    (void)count;
    if (!function)
        check_fail("%s is not in this OpenGL", name);
}

static void after_call(void *result, const char *name, GLADapiproc function, int count, ...) {
    (void)result, (void)function, (void)count;
    GLenum error = glad_glGetError();
    refused = refused || (error != GL_NO_ERROR && error != GL_INVALID_ENUM);
    if (error == GL_NO_ERROR || first_error[0])
        return;
    check_append(first_error, sizeof first_error, "%s in %s", error_name(error), name);
    GLenum status = glad_glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
    if (error == GL_INVALID_FRAMEBUFFER_OPERATION)
        check_append(first_error, sizeof first_error, " (the bound framebuffer is %s)",
                     framebuffer_status(status));
    void *frames[16];
    gl_append_caller(first_error, sizeof first_error, frames, backtrace(frames, 16));
}

bool gl_load(GLADloadfunc load) {
    int version = gladLoadGL(load);
    if (version < GLAD_MAKE_VERSION(4, 1))
        return check_fail("this context offers OpenGL %d.%d; 4.1 core is needed (install Mesa's llvmpipe)",
                          GLAD_VERSION_MAJOR(version), GLAD_VERSION_MINOR(version));
    gladSetGLPreCallback(before_call);
    gladSetGLPostCallback(after_call);
    gladInstallGLDebug();
    return true;
}

const char *gl_error(void) {
    return first_error;
}

bool gl_refused(void) {
    return refused;
}

void gl_clear_error(void) {
    first_error[0] = '\0';
    refused = false;
}

bool gl_check_framebuffer(const char *what) {
    GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    return status == GL_FRAMEBUFFER_COMPLETE ||
           check_fail("the framebuffer of the %s is not complete: %s", what, framebuffer_status(status));
}
