// What is drawn over the picture to explain it: the shadow volumes of the casters, as haze, and what the
// lights' maps see. By the scene alone, so that it is right whatever the lab draws. Needs a context.
#pragma once

#include "program.h"
#include "protocol/protocol.h"
#include "scene/image.h"
#include "target.h"
#include "window/view_state.h"

#include <stdbool.h>

typedef struct Guides {
    Program depth, haze, lines, texels, copy;
    GLuint texture, array, buffer;
    Target target; // as large as the last picture
    bool created;
} Guides;

typedef struct GuideWish {
    bool volumes;
    LightShown light;
    float map_size; // texels along a side; 0: the lab has none
} GuideWish;

// Draws over the picture, which shows the request's scene to its camera, pixel by pixel. Makes what it draws
// with when it is first asked. False with a message.
bool guides_draw(Guides *guides, const GuideWish *wish, const Request *request, Image *picture);
void guides_destroy(Guides *guides); // accepts zeroed guides
