// The window's picture on the screen. Needs a context.
#pragma once

#include "image.h"
#include "program.h"

#include <stdbool.h>

typedef struct Screen {
    Program program;
    GLuint texture, array;
    int width, height; // of the picture, 0: none yet
} Screen;

// What of the window a picture covers, pixels; y upwards, as GL has it.
typedef struct Place {
    int x, y, width, height;
} Place;

bool screen_create(Screen *screen);
void screen_destroy(Screen *screen); // accepts a zeroed screen

void screen_upload(Screen *screen, const Image *picture);

// Where a picture of this size lies: in the middle, each of its pixels enlarged `pixel` times when the
// picture is the one for this window, else (until the next one comes) stretched as far as it fits.
Place screen_place(int width, int height, int window_width, int window_height, int pixel);

// Clears the window's framebuffer and draws the picture; unscaled ones bit for bit.
void screen_draw(const Screen *screen, int window_width, int window_height, int pixel);

// Reads a part of the window's back buffer, without alpha. False with a message.
bool screen_read(Image *image, const Place *place);
