// The six maps of a lamp in the middle of the scene, and what they are drawn with.
#pragma once

#include "lab.h"
#include "maps.h"

enum { CUBE_FACES = 6 };

// Given: an array of cubes of depth maps, one cube for each light that a scene may have.
static GLuint create_cube_array(int size) {
    GLuint texture;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_CUBE_MAP_ARRAY, texture);
    glTexImage3D(GL_TEXTURE_CUBE_MAP_ARRAY, 0, GL_DEPTH_COMPONENT24, size, size,
                 CUBE_FACES * SCENE_MAX_LIGHTS, 0, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    set_comparison(GL_TEXTURE_CUBE_MAP_ARRAY);
    return texture;
}

// Given: a framebuffer for depths alone, to which nothing is attached yet.
static GLuint create_depth_framebuffer(void) {
    GLuint framebuffer;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    return framebuffer;
}

// From the world to the clip space of one face of the lamp's cube: 0 to 5 are +x, -x, +y, -y, +z, -z.
static mat4s face_clip_from_world(const Light *lamp, int face) {
    // TODO(11.5): look from lamp->position along the face's axis, with the up vector of the handout's table,
    // and an angle of 90 degrees; the planes are those of the lamp. Look up: glms_lookat, glms_perspective.
    // Until then all faces see what the lamp sees of its target, through a narrow window.
    UNUSED(face);
    Light narrow = *lamp;
    narrow.fov_y = 0.5f;
    return shadow_map_clip_from_world(&narrow);
}
