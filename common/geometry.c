#include "geometry.h"

bool geometry_create(Target *geometry, const Frame *frame) {
    return target_create(geometry, frame->width, frame->height, GL_RGBA32F, GL_DEPTH_COMPONENT24);
}

void geometry_draw(const Target *geometry, const Frame *frame, const Program *program) {
    const Camera *camera = &frame->scene->camera;
    target_bind(geometry);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    program_set_mat4(program, "u_view_from_world", camera_view_from_world(camera));
    draw_scene(frame, program, frame_clip_from_world(frame), camera->eye);
}

void geometry_use(const Target *geometry, const Frame *frame, const Program *program) {
    float aspect = (float)frame->width / (float)frame->height;
    program_set_texture(program, "u_geometry", 0, GL_TEXTURE_2D, geometry->color);
    program_set_mat4(program, "u_clip_from_view", camera_clip_from_view(&frame->scene->camera, aspect));
}
