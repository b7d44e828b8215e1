// Shows which triangle of which object each pixel belongs to, whatever the lab draws.
#pragma once

#include "draw.h"

#include <stdbool.h>

// Draws the frame's scene as its camera sees it into the frame's framebuffer. Red is the object's number + 1,
// green and blue the low and high byte of the triangle's number in its mesh, in 255ths; the background is
// black. False with a message.
bool primitives_view_draw(const Frame *frame);
