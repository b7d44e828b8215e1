// What is late in a new process and the same for every lab, done before there is one.
#pragma once

#include "worker/stage_view.h"

// Draws a frame of ours and its view as a stage, and frees all that it made: the driver has compiled and laid
// out by then what it needs for any frame. False with a message.
bool warm_up(const StageView *view);
