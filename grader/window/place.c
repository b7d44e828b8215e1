#include "window/place.h"

#include <stdbool.h>

Place place_picture(int width, int height, int window_width, int window_height, int pixel) {
    Place place = {.width = width * pixel, .height = height * pixel};
    if (width != window_width / pixel || height != window_height / pixel) {
        bool wide = (long)width * window_height > (long)height * window_width;
        place.width = wide ? window_width : (int)((long)width * window_height / height);
        place.height = wide ? (int)((long)height * window_width / width) : window_height;
    }
    place.x = (window_width - place.width) / 2;
    place.y = (window_height - place.height) / 2;
    return place;
}

Place place_enlarged(int width, int height, int window_width, int window_height) {
    const int across = window_width / width, down = window_height / height,
              pixel = across < down ? across : down;
    if (pixel < 1)
        return place_picture(width, height, window_width, window_height, 1);
    return (Place){.x = (window_width - width * pixel) / 2,
                   .y = (window_height - height * pixel) / 2,
                   .width = width * pixel,
                   .height = height * pixel};
}
