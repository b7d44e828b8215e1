// What is drawn on the picture itself: the line between two pictures, with the names of both, and the legend
// of the counts.
#pragma once

#include "window/app.h"
#include "window/place.h"
#include "window/text.h"

// Puts them into `text`, for a picture that lies there in a window of this size, pixels.
void marks_put(Text *text, const App *app, const Place *place, int width, int height);
