// Counts what a lab's frame costs on any machine: reads of textures, fragments, texels that are cleared.
//
// Interface: counted_start before any code of a lab's runs; then for each frame counted_begin, counted_lab
// around what the lab does, and counted_end.
#pragma once

#include "protocol/protocol.h"

#include <stdbool.h>

// From now on all shaders are compiled with counters (COUNTED_READS), or with counters and without what
// textures hold (COUNTED_BLIND). False with a message when OpenGL cannot count.
bool counted_start(int kind);

// Do shaders count?
bool counted_is_on(void);

// Nothing was counted yet.
void counted_begin(void);

// Is what OpenGL is asked for from now on the lab's?
void counted_lab(bool runs);

// Adds what was counted since; what it finds comes into the frame's sum.
void counted_collect(void);

// The frame's sum; zero where shaders do not count.
FrameCounts counted_end(void);
