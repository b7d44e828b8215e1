// The window itself: opened with OpenGL 4.1, its sizes, and what is drawn into it.
#pragma once

#include "window/app.h"
#include "window/guides.h"
#include "window/screen.h"
#include "window/text.h"

typedef struct GLFWwindow GLFWwindow;

typedef struct Window {
    GLFWwindow *handle;
    Screen screen;
    Guides guides;
    Text text;
    float scale;       // of the monitor's contents: 2 on a HiDPI one
    float letters;     // their height, pixels
    int width, height; // pixels
    int before[4];     // place and size before full screen, window units
} Window;

// Opens it, unseen, with this size in window units. False with a message.
bool window_open(Window *window, int width, int height);
void window_close(Window *window); // accepts a zeroed window

// Asks for the sizes again; text and pixels follow the monitor that the window is on. False with a message.
bool window_measure(Window *window);

// The side of a pixel of the picture, in those of the window, for the state's `pixel`.
int window_pixel(const Window *window, int pixel);

// In how many pages the keys are shown.
int window_help_pages(const Window *window);

// Where the picture lies, pixels; empty while there is none.
Place window_place(const Window *window, const App *app);

// The pixel of the picture at a place in window units.
void window_find(const Window *window, const App *app, double x, double y, int found[2]);

// How far across the picture a place in window units lies: 0 at its left side, 1 at its right.
float window_share(const Window *window, const App *app, double x);

// Shows another picture of the app, with the guides that its state asks for. False with a message.
bool window_take(Window *window, App *app);

// Draws the picture and what is written over it. `cursor` as in hud_put.
void window_draw(Window *window, const App *app, const int cursor[2]);

// Writes the picture with its marks (the line of a split, names, the legend of counts), but without the text
// at its borders, to a PNG. False with a message.
bool window_save(Window *window, const App *app, const char *path);

// To full screen and back.
void window_change_full_screen(Window *window);
