#include "shadow_map.h"

#include "target.h"

bool shadow_map_create(ShadowMap *map, int size, GLenum depth_format) {
    Target target;
    *map = (ShadowMap){0};
    if (!target_create(&target, size, size, 0, depth_format))
        return false;
    *map = (ShadowMap){.framebuffer = target.framebuffer, .texture = target.depth, .size = size};
    glBindTexture(GL_TEXTURE_2D, map->texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, (float[]){1, 1, 1, 1});
    return true;
}

void shadow_map_destroy(ShadowMap *map) {
    glDeleteFramebuffers(1, &map->framebuffer);
    glDeleteTextures(1, &map->texture);
    *map = (ShadowMap){0};
}

mat4s shadow_map_clip_from_world(const Light *light) {
    float r = light->half_size;
    mat4s clip_from_light = light->kind == LIGHT_DIRECTIONAL
                                ? glms_ortho(-r, r, -r, r, light->near_plane, light->far_plane)
                                : glms_perspective(light->fov_y, 1, light->near_plane, light->far_plane);
    mat4s light_from_world = light_is_overhead(light)
                                 ? light_view_from_overhead(light)
                                 : glms_lookat(light->position, light->target, vec3_make(0, 1, 0));
    return glms_mat4_mul(clip_from_light, light_from_world);
}

void shadow_map_begin(const ShadowMap *map) {
    glBindFramebuffer(GL_FRAMEBUFFER, map->framebuffer);
    glViewport(0, 0, map->size, map->size);
    glClear(GL_DEPTH_BUFFER_BIT);
}
