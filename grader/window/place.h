// Where the picture lies in the window. Pure.
#pragma once

// What of the window a picture covers, pixels; y upwards, as GL has it.
typedef struct Place {
    int x, y, width, height;
} Place;

// Where a picture of this size lies: in the middle, each of its pixels enlarged `pixel` times when the
// picture is the one for this window, else (until the next one comes) stretched as far as it fits.
Place place_picture(int width, int height, int window_width, int window_height, int pixel);

// The same for a picture that was not made for this window: each of its pixels is as large as there is room
// for all of them, a whole number; smaller only where the picture is larger than the window.
Place place_enlarged(int width, int height, int window_width, int window_height);
