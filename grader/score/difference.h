// Where a picture is wrong, in colours: yellow where it is too bright (false light), blue where it is too
// dark (false shadow), magenta where only the colour is another one.
#pragma once

#include "scene/image.h"

// The colours, 0xrrggbb.
enum { DIFFERENCE_BRIGHTER = 0xffd020, DIFFERENCE_DARKER = 0x3070ff, DIFFERENCE_OTHER = 0xff30ff };

// Numbers of pixels of each kind.
typedef struct Difference {
    size_t brighter, darker, other;
} Difference;

// Draws `picture`: the reference in dim grey, under the colours where `yours` differs from it by more than
// the score's tolerance. All three have one size. With alpha 255.
Difference difference_mark(Image *picture, const Image *yours, const Image *reference);
