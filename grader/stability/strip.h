// A frame to look at: the method's visibility, the truth and the error in one picture.
#pragma once

#include "study/truth_view.h"

// Side by side; one below the other for a frame that is much wider than high, whose rows are then drawn
// several times. Yellow is false light, blue false shadow, black what does not count. False with a message.
bool strip_create(Image *strip, const TruthView *truth_view, const Measured *measured);
