// Tells RenderDoc, when the worker runs under it, where a frame begins and ends: without a window it cannot
// see that by itself. Without RenderDoc, or without its header at build time, nothing happens.
#pragma once

// Around all GL calls of a frame.
void renderdoc_begin(void);
void renderdoc_end(void);
