#include "window/screen.h"

#include "scene/check.h"

#include <string.h>

bool screen_create(Screen *screen) {
    memset(screen, 0, sizeof *screen);
    if (!program_create(&screen->program, &(ProgramFiles){"fullscreen.vert", "picture.frag", NULL}))
        return false;
    glGenTextures(1, &screen->texture);
    glGenVertexArrays(1, &screen->array);
    glDisable(GL_DITHER);
    return true;
}

void screen_destroy(Screen *screen) {
    program_destroy(&screen->program);
    if (screen->texture)
        glDeleteTextures(1, &screen->texture);
    if (screen->array)
        glDeleteVertexArrays(1, &screen->array);
    memset(screen, 0, sizeof *screen);
}

void screen_fill(GLuint texture, const Image *picture) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture->width, picture->height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 picture->rgba);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void screen_upload(Screen *screen, const Image *picture) {
    screen_fill(screen->texture, picture);
    screen->width = picture->width;
    screen->height = picture->height;
}

// Draws a part of the picture (lower left corner and size, 0..1) over a place of the window.
static void draw_part(const Screen *screen, vec4s part, const Place *place, GLint filter) {
    glBindTexture(GL_TEXTURE_2D, screen->texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glViewport(place->x, place->y, place->width, place->height);
    program_set_texture(&screen->program, "u_picture", 0, GL_TEXTURE_2D, screen->texture);
    program_set_vec4s(&screen->program, "u_part", &part, 1);
    glUseProgram(screen->program.id);
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(screen->array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void screen_draw(const Screen *screen, int window_width, int window_height, const Place *place) {
    glBindFramebuffer(GL_FRAMEBUFFER, SCREEN_FRAMEBUFFER);
    glViewport(0, 0, window_width, window_height);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (screen->width == 0)
        return;
    bool whole = place->width % screen->width == 0 && place->height % screen->height == 0;
    draw_part(screen, (vec4s){{0, 0, 1, 1}}, place, whole ? GL_NEAREST : GL_LINEAR);
    glViewport(0, 0, window_width, window_height);
}

void screen_loupe(const Screen *screen, const int pixel[2], int side, const Place *place) {
    float width = (float)screen->width, height = (float)screen->height;
    float columns = (float)place->width / (float)side, rows = (float)place->height / (float)side;
    vec4s part = {{((float)pixel[0] + 0.5F - columns / 2) / width,
                   (height - (float)pixel[1] - 0.5F - rows / 2) / height, columns / width, rows / height}};
    draw_part(screen, part, place, GL_NEAREST);
}

bool screen_read(Image *image, const Place *place) {
    image_destroy(image);
    if (!image_create(image, place->width, place->height))
        return check_fail("out of memory for the picture of the window");
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    for (int y = 0; y < place->height; y++)
        glReadPixels(place->x, place->y + place->height - 1 - y, place->width, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                     image->rgba + image_at(image, 0, y));
    return true;
}
