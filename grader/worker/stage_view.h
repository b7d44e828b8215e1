// Shows a lab's intermediate texture as a picture.
#pragma once

#include "program.h"
#include "protocol/protocol.h"
#include "target.h"

#include <stdbool.h>

typedef struct StageView {
    Program program;
    GLuint sampler; // nearest, without depth comparison, whatever the lab has set on its texture
} StageView;

// Once per context. False with a message.
bool stage_view_create(StageView *view);

// Width and height of its first level in facts; left alone when there is no such 2D texture.
void stage_view_measure(GLuint texture, FrameFacts *facts);

// Fills `target` with the texture: colour as it is, depth as grey. Magenta when there is no such 2D texture.
// With `own_shape` it keeps its shape, as large as there is room, on dark grey; unless that would be a
// thread.
void stage_view_draw(const StageView *view, const Target *target, GLuint texture, bool own_shape);
