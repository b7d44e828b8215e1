// What a frame's framebuffer holds, as textures that a lab can name as stages. The state that the passes left
// behind does not matter; afterwards it is that of gl_reset.
#pragma once

#include "draw.h"
#include "target.h"

#include <stdbool.h>

enum { FRAME_VIEW_ROWS = 3 };

typedef struct FrameView {
    Target counts; // the stencil: black 0, greys 1 to 3, white 4 and more, red -1 (255), towards yellow -4
    Target rows;   // the last FRAME_VIEW_ROWS rows of the picture
    Target
        haze; // the faces of the volumes before what is seen: red those that look to the eye, blue the others
} FrameView;

// For frames of this size. False with a message when a target cannot be made.
bool frame_view_create(FrameView *view, const Frame *frame);
void frame_view_destroy(FrameView *view); // accepts a zeroed view

// Fills the first two. `program` is made of fullscreen.vert and constant.frag.
void frame_view_draw(const FrameView *view, const Frame *frame, const Program *program);

// Fills the haze, by the depth that the framebuffer `surfaces` holds (0: that of the frame); `volumes` draws
// the casters' volumes, at infinity also without an infinite far plane.
void frame_view_draw_haze(const FrameView *view, const Frame *frame, GLuint surfaces, const Program *volumes,
                          mat4s clip_from_world);
