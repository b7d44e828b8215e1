#include "study/pictures.h"

#include "scene/check.h"
#include "scene/image.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

void pictures_path(char path[FILES_PATH], const char *output, const char *scene) {
    char file[FILES_PATH];
    snprintf(file, sizeof file, "frames/%s.png", scene);
    files_join(path, output, file);
}

void pictures_frame_path(char path[FILES_PATH], const char *output, uint64_t key) {
    char name[32];
    snprintf(name, sizeof name, "%016" PRIx64, key);
    pictures_path(path, output, name);
}

bool pictures_write(const char *path, MetricsSize size, const float *numbers, const uint8_t *mask) {
    Image image = {0};
    if (!image_create(&image, size.width, size.height))
        return check_fail("out of memory for a picture");
    for (size_t i = 0; i < (size_t)size.width * (size_t)size.height; i++) {
        uint8_t value = (uint8_t)lrintf(255 * (isfinite(numbers[i]) ? numbers[i] : 0));
        const uint8_t pixel[4] = {value, mask ? (uint8_t)(255 * mask[i]) : value, value, 255};
        memcpy(image.rgba + 4 * i, pixel, 4);
    }
    bool ok = image_write_png(&image, path);
    image_destroy(&image);
    return ok;
}
