// What a frame of shadow volumes holds beside its picture, as textures that a lab can name as stages. The
// state that the passes left behind does not matter; afterwards it is that of gl_reset.
#pragma once

#include "draw.h"
#include "target.h"

#include <stdbool.h>

enum { FRAME_VIEW_ROWS = 3 };

typedef struct FrameView {
    Target ambient; // the first colour of the framebuffer of the surfaces
    Target counts;  // the stencil: black 0, greys 1 to 3, white 4 and more, red -1 (255), towards yellow -4
    Target rows;    // the last FRAME_VIEW_ROWS rows of the picture
    Target haze;    // faces of the volumes, see FRAME_VIEW_STAGES: one texture, as one stage is asked for
} FrameView;

// The stages of a FrameView, for a lab's table. Faces of the volumes that look to the eye are reddish, those
// that look away bluish.
// - fins: the triangles that look towards the light, and a fin on each edge of the silhouette.
// - haze: the faces before what is seen; haze behind: those behind it and on it. No far plane cuts them off.
// - haze to the horizon: the faces before what is seen, with the far caps, as clip_from_world cuts them off
//   (or does not: when the lab draws with GL_DEPTH_CLAMP, this does, too); surfaces are grey.
#define FRAME_VIEW_STAGES(view)                                                                              \
    {"ambient", &(view).ambient.color}, {"stencil counts", &(view).counts.color},                            \
        {"last rows", &(view).rows.color}, {"fins", &(view).haze.color}, {"haze", &(view).haze.color},       \
        {"haze behind", &(view).haze.color}, {                                                               \
        "haze to the horizon", &(view).haze.color                                                            \
    }

// For frames of this size. False with a message when a target cannot be made.
bool frame_view_create(FrameView *view, const Frame *frame);
void frame_view_destroy(FrameView *view); // accepts a zeroed view

// Fills "ambient", "stencil counts" or "last rows", whichever frame->view asks for. `surfaces` is the
// framebuffer of the surfaces (0: there is none yet, and no ambient light); `constant` is made of
// fullscreen.vert and constant.frag.
void frame_view_draw(const FrameView *view, const Frame *frame, GLuint surfaces, const Program *constant);

// The same for the stages of the volumes, by the depth that `surfaces` holds (0: that of the frame);
// `volumes` draws the casters' volumes.
void frame_view_draw_haze(const FrameView *view, const Frame *frame, GLuint surfaces, const Program *volumes,
                          const Program *constant, mat4s clip_from_world);
