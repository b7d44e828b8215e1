// The map of moments, and its blur.
#pragma once

#include "lab.h"
#include "target.h"

// `map` is drawn and looked at; `row` is what a blur along the rows leaves for one along the columns.
typedef struct Moments {
    Target map, row;
} Moments;

static bool moments_create(Moments *moments, int size, GLenum format) {
    return target_create(&moments->map, size, size, format, GL_DEPTH_COMPONENT24) &&
           target_create(&moments->row, size, size, format, 0);
}

static void moments_destroy(Moments *moments) {
    target_destroy(&moments->map);
    target_destroy(&moments->row);
}

// Binds the map; where nothing will be drawn, it holds what is at the light's far plane.
static void moments_begin(const Moments *moments) {
    target_bind(&moments->map);
#ifdef SOLUTION // 16.2
    glClearColor(1, 1, 1, 1);
#else
    // TODO(16.2): empty texels hold 0, as if something stood right before the light. What are the moments of
    // the far plane?
    glClearColor(0, 0, 0, 1);
#endif
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

// Given: one blur, from a texture into a target.
static void blur_into(const Program *blur, const Target *target, GLuint source, vec3s step, int radius) {
    target_bind(target);
    program_set_texture(blur, "u_source", 0, GL_TEXTURE_2D, source);
    program_set_vec3(blur, "u_step", step);
    program_set_int(blur, "u_radius", radius);
    draw_fullscreen(blur);
}

static void moments_blur(const Moments *moments, const Program *blur, int radius) {
    float texel = 1 / (float)moments->map.width;
    glDisable(GL_DEPTH_TEST);
    blur_into(blur, &moments->row, moments->map.color, vec3_make(texel, 0, 0), radius);
#ifdef SOLUTION // 16.5
    blur_into(blur, &moments->map, moments->row.color, vec3_make(0, texel, 0), radius);
#else
    // TODO(16.5), second part: blur the columns of what the first blur left, back into the map.
#endif
    glEnable(GL_DEPTH_TEST);
}

// How the map is looked up: between texels, and with or without its smaller copies.
static void moments_filter(const Moments *moments, bool mipmaps) {
    glBindTexture(GL_TEXTURE_2D, moments->map.color);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
#ifdef SOLUTION // 16.6
    if (mipmaps) {
        glGenerateMipmap(GL_TEXTURE_2D);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    }
#else
    // TODO(16.6): only with mipmaps: have the driver make the smaller copies, and let lookups blend between
    // two of them. Look up: glGenerateMipmap, GL_TEXTURE_MIN_FILTER.
    UNUSED(mipmaps);
#endif
}
