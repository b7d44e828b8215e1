#include "gl_blit.h"

typedef struct DepthFormat {
    GLint depth_bits, stencil_bits;
} DepthFormat;

static DepthFormat texture_format(GLuint texture) {
    DepthFormat format;
    GLint bound;
    glad_glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    glad_glBindTexture(GL_TEXTURE_2D, texture);
    glad_glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_DEPTH_SIZE, &format.depth_bits);
    glad_glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_STENCIL_SIZE, &format.stencil_bits);
    glad_glBindTexture(GL_TEXTURE_2D, (GLuint)bound);
    return format;
}

static DepthFormat renderbuffer_format(GLuint renderbuffer) {
    DepthFormat format;
    GLint bound;
    glad_glGetIntegerv(GL_RENDERBUFFER_BINDING, &bound);
    glad_glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    glad_glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_DEPTH_SIZE, &format.depth_bits);
    glad_glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_STENCIL_SIZE, &format.stencil_bits);
    glad_glBindRenderbuffer(GL_RENDERBUFFER, (GLuint)bound);
    return format;
}

static bool find_format(GLenum target, DepthFormat *format) {
    GLint type, name;
    glad_glGetFramebufferAttachmentParameteriv(target, GL_DEPTH_ATTACHMENT,
                                               GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type != GL_TEXTURE && type != GL_RENDERBUFFER)
        return false;
    glad_glGetFramebufferAttachmentParameteriv(target, GL_DEPTH_ATTACHMENT,
                                               GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
    *format = type == GL_TEXTURE ? texture_format((GLuint)name) : renderbuffer_format((GLuint)name);
    return true;
}

bool gl_blit_mixes_depths(void) {
    DepthFormat from, to;
    bool both = find_format(GL_READ_FRAMEBUFFER, &from) && find_format(GL_DRAW_FRAMEBUFFER, &to);
    bool mixed = both && (from.depth_bits != to.depth_bits || from.stencil_bits != to.stencil_bits);
    while (glad_glGetError() != GL_NO_ERROR) // an array or a cube is not bound as GL_TEXTURE_2D: not judged
        mixed = false;
    return mixed;
}
