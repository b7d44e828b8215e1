#include "target.h"

static GLenum pixel_format(GLenum internal_format) {
    switch (internal_format) {
    case GL_DEPTH24_STENCIL8:
    case GL_DEPTH32F_STENCIL8:
        return GL_DEPTH_STENCIL;
    case GL_DEPTH_COMPONENT16:
    case GL_DEPTH_COMPONENT24:
    case GL_DEPTH_COMPONENT32F:
        return GL_DEPTH_COMPONENT;
    default:
        return GL_RGBA;
    }
}

static GLenum pixel_type(GLenum internal_format) {
    switch (internal_format) {
    case GL_DEPTH24_STENCIL8:
        return GL_UNSIGNED_INT_24_8;
    case GL_DEPTH32F_STENCIL8:
        return GL_FLOAT_32_UNSIGNED_INT_24_8_REV;
    default:
        return GL_FLOAT;
    }
}

GLuint target_create_texture(int width, int height, GLenum internal_format) {
    GLuint texture;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)internal_format, width, height, 0, pixel_format(internal_format),
                 pixel_type(internal_format), NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

bool target_create(Target *target, int width, int height, GLenum color_format, GLenum depth_format) {
    *target = (Target){.width = width, .height = height};
    glGenFramebuffers(1, &target->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    if (color_format) {
        target->color = target_create_texture(width, height, color_format);
        glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target->color, 0);
    } else {
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
    }
    if (depth_format) {
        bool stencil = pixel_format(depth_format) == GL_DEPTH_STENCIL;
        target->depth = target_create_texture(width, height, depth_format);
        glFramebufferTexture(GL_FRAMEBUFFER, stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                             target->depth, 0);
    }
    if (gl_check_framebuffer("target"))
        return true;
    target_destroy(target);
    return false;
}

void target_destroy(Target *target) {
    glDeleteFramebuffers(1, &target->framebuffer);
    glDeleteTextures(1, &target->color);
    glDeleteTextures(1, &target->depth);
    *target = (Target){0};
}

void target_bind(const Target *target) {
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glViewport(0, 0, target->width, target->height);
}
