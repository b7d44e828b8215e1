// What is written over the picture: what is shown, the knobs, times, problems, keys.
#pragma once

#include "window/app.h"
#include "window/text.h"

// Puts everything into `text`, for a window of this size in pixels. `cursor` is the mouse in pixels of the
// picture, negative outside.
void hud_put(Text *text, const App *app, int width, int height, const int cursor[2]);

// The window's title: lab, what is shown, the selected knob.
void hud_title(const App *app, char *title, size_t size);
