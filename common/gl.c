// Every call of OpenGL goes through the two functions that glad calls before and after it: they keep the
// first error with the name and the place of its call, and say what a framebuffer lacks.
#include "gl.h"

#include "gl_blit.h"
#include "gl_subroutines.h"
#include "remark.h"

#include "scene/check.h"

#include <dlfcn.h>
#include <execinfo.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>

static char first_error[512];
static bool refused;
static unsigned long first_error_place;
static GLuint last_framebuffer; // the last one bound that is not 0

typedef void(GLAD_API_PTR *BindMany)(GLuint first, GLsizei count, const GLuint *names);
static void(GLAD_API_PTR *memory_barrier)(GLbitfield barriers); // of OpenGL 4.2; NULL: the driver is older
static GlWatch watching;
static BindMany bind_textures, bind_samplers; // of OpenGL 4.4; NULL: the driver is older

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

unsigned long gl_caller(void *const *frames, int count) {
    for (int i = 0; i < count; i++) {
        Dl_info info;
        // A return address points behind its call.
        if (dladdr(frames[i], &info) && info.dli_fname && strstr(info.dli_fname, "lab.so"))
            return (unsigned long)((uintptr_t)frames[i] - (uintptr_t)info.dli_fbase - 1);
    }
    return 0;
}

static void before_call(const char *name, GLADapiproc function, int count, ...) {
    va_list arguments;
    if (!function)
        check_fail("%s is not in this OpenGL", name);
    if (!watching)
        return;
    va_start(arguments, count);
    watching(name, count, arguments);
    va_end(arguments);
}

static bool begins_with(const char *name, const char *start) {
    return strncmp(name, start, strlen(start)) == 0;
}

static bool is_bound(GLenum binding) {
    GLint framebuffer = 0;
    glad_glGetIntegerv(binding, &framebuffer);
    return framebuffer != 0;
}

// OSMesa has a default framebuffer, of one pixel, and EGL without a surface has none: what draws into it or
// reads from it is the same error by both routes.
static bool misses_framebuffer(const char *name) {
    if (!strchr("BCDMR", name[2])) // by which the names below go on behind "gl"
        return false;
    const bool blits = begins_with(name, "glBlit");
    const bool draws = blits || (begins_with(name, "glDraw") && !begins_with(name, "glDrawBuffer")) ||
                       begins_with(name, "glMultiDraw") || strcmp(name, "glClear") == 0 ||
                       begins_with(name, "glClearBuffer");
    const bool reads = blits || strcmp(name, "glReadPixels") == 0 || begins_with(name, "glCopyTex");
    return (draws && !is_bound(GL_DRAW_FRAMEBUFFER_BINDING)) ||
           (reads && !is_bound(GL_READ_FRAMEBUFFER_BINDING));
}

static void note_framebuffer(va_list arguments) {
    (void)va_arg(arguments, GLenum);
    const GLuint framebuffer = va_arg(arguments, GLuint);
    last_framebuffer = framebuffer ? framebuffer : last_framebuffer;
}

// Only the mask matters, the ninth argument.
static bool mixes_depths(va_list arguments) {
    for (int i = 0; i < 8; i++)
        (void)va_arg(arguments, GLint);
    return (va_arg(arguments, GLbitfield) & GL_DEPTH_BUFFER_BIT) && gl_blit_mixes_depths();
}

static void after_call(void *result, const char *name, GLADapiproc function, int count, ...) {
    (void)result;
    GLenum error = glad_glGetError();
    remark_call(name);
    bool mixed_depths = false;
    if (function == (GLADapiproc)glad_glBindFramebuffer) {
        va_list arguments;
        va_start(arguments, count);
        note_framebuffer(arguments);
        va_end(arguments);
    }
    if (error == GL_NO_ERROR && !refused && misses_framebuffer(name))
        error = GL_INVALID_FRAMEBUFFER_OPERATION;
    if (error == GL_NO_ERROR && function == (GLADapiproc)glad_glBlitFramebuffer) {
        va_list arguments;
        va_start(arguments, count);
        mixed_depths = mixes_depths(arguments);
        va_end(arguments);
        error = mixed_depths ? GL_INVALID_OPERATION : error;
    }
    refused = refused || (error != GL_NO_ERROR && error != GL_INVALID_ENUM);
    if (error == GL_NO_ERROR || first_error[0])
        return;
    check_append(first_error, sizeof first_error, "%s in %s", error_name(error), name);
    GLenum status = misses_framebuffer(name) ? GL_FRAMEBUFFER_UNDEFINED
                                             : glad_glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
    if (error == GL_INVALID_FRAMEBUFFER_OPERATION)
        check_append(first_error, sizeof first_error, " (the bound framebuffer is %s)",
                     framebuffer_status(status));
    if (mixed_depths)
        check_append(first_error, sizeof first_error, " (the two depth buffers have different formats)");
    void *frames[16];
    first_error_place = gl_caller(frames, backtrace(frames, 16));
}

bool gl_load(GLADloadfunc load) {
    int version = gladLoadGL(load);
    if (version < GLAD_MAKE_VERSION(4, 1))
        return check_fail("this context offers OpenGL %d.%d; 4.1 core is needed (install Mesa's llvmpipe)",
                          GLAD_VERSION_MAJOR(version), GLAD_VERSION_MINOR(version));
    const bool has_many = version >= GLAD_MAKE_VERSION(4, 4);
    bind_textures = has_many ? (BindMany)load("glBindTextures") : NULL;
    bind_samplers = has_many ? (BindMany)load("glBindSamplers") : NULL;
    memory_barrier =
        version >= GLAD_MAKE_VERSION(4, 2) ? (void(GLAD_API_PTR *)(GLbitfield))load("glMemoryBarrier") : NULL;
    gl_subroutines_guard();
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

unsigned long gl_error_place(void) {
    return first_error_place;
}

void gl_clear_error(void) {
    first_error_place = 0;
    first_error[0] = '\0';
    refused = false;
}

void gl_watch(GlWatch watch) {
    watching = watch;
}

bool gl_finish_writes(void) {
    static const GLbitfield ALL = 0xFFFFFFFF;
    if (memory_barrier)
        memory_barrier(ALL);
    return memory_barrier != NULL;
}

bool gl_unbind_textures(GLuint units) {
    if (!bind_textures || !bind_samplers)
        return false;
    bind_textures(0, (GLsizei)units, NULL);
    bind_samplers(0, (GLsizei)units, NULL);
    return true;
}

void gl_forget_framebuffer(void) {
    last_framebuffer = 0;
}

// Of the framebuffer that is bound, or else of the last one that was.
static GLenum status_of_framebuffer(void) {
    const bool unbound = !is_bound(GL_DRAW_FRAMEBUFFER_BINDING);
    if (unbound && !glIsFramebuffer(last_framebuffer))
        return GL_FRAMEBUFFER_UNDEFINED;
    if (unbound)
        glad_glBindFramebuffer(GL_DRAW_FRAMEBUFFER, last_framebuffer);
    const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
    if (unbound)
        glad_glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    return status;
}

bool gl_check_framebuffer(const char *what) {
    const GLenum status = status_of_framebuffer();
    if (status == GL_FRAMEBUFFER_UNDEFINED)
        return check_fail("the framebuffer of the %s cannot be checked: none was bound; call "
                          "glBindFramebuffer with it before",
                          what);
    return status == GL_FRAMEBUFFER_COMPLETE ||
           check_fail("the framebuffer of the %s is not complete: %s", what, framebuffer_status(status));
}
