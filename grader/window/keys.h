// The window's keys and its mouse: what each does, in one table that F1 shows.
#pragma once

#include "window/app.h"

// What a key can ask of the window itself.
typedef enum Wish { WISH_NOTHING, WISH_QUIT, WISH_SAVE, WISH_FULL_SCREEN } Wish;

// Does what GLFW's key with these modifiers means; `repeated` while it is held down.
Wish keys_press(App *app, int key, int modifiers, bool repeated);

// The rows of the help: keys and what they do; false past the last.
bool keys_help(int row, const char **keys, const char **meaning);

// The mouse has moved from (x, y) by (dx, dy), in parts of the window's height, with these of GLFW's buttons
// (as bits) and modifiers down.
void keys_drag(App *app, int buttons, int modifiers, float dx, float dy);

// The wheel was turned towards the picture by this many steps.
void keys_scroll(App *app, float steps);
