// The window's picture on the screen. Needs a context.
#pragma once

#include "scene/image.h"
#include "window/place.h"
#include "program.h"

#include <stdbool.h>

enum { SCREEN_FRAMEBUFFER = 0 }; // the window's own

typedef struct Screen {
    Program program;
    GLuint texture, array;
    int width, height; // of the picture, 0: none yet
} Screen;

// False with a message.
bool screen_create(Screen *screen);
void screen_destroy(Screen *screen); // accepts a zeroed screen

// Puts a picture of any size into a texture, clamped to its edges. The texture stays bound.
void screen_fill(GLuint texture, const Image *picture);

// Takes another picture, of any size.
void screen_upload(Screen *screen, const Image *picture);

// Clears the window's framebuffer and draws the picture there; unscaled ones bit for bit.
void screen_draw(const Screen *screen, int window_width, int window_height, const Place *place);

// Draws what lies around a pixel of the picture (columns from the left, rows from the top), enlarged: one
// pixel of the picture is `side` pixels of the window, inside `place`.
void screen_loupe(const Screen *screen, const int pixel[2], int side, const Place *place);

// Reads a part of the window's back buffer, without alpha. False with a message.
bool screen_read(Image *image, const Place *place);
