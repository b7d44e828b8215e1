// A shader's text with counters in it: each read of a texture and each fragment counts itself. No GL.
#pragma once

#include <stdbool.h>

// The text with counters for the fragment stage, or, for another stage, with all reads of textures made
// unknown names: how often a vertex shader runs is up to the driver. `blind`: reads give 1 in the place of
// what the texture holds. The caller frees it; NULL with a message where the text could get at the counters.
char *counted_shader_text(const char *text, bool fragment, bool blind);
