// The pictures that a study keeps in OUTPUT/frames: each setting's frame, and each scene's truth.
#pragma once

#include "base/files.h"
#include "truth/metrics.h"

#include <stdbool.h>
#include <stdint.h>

// Where the truth of a scene lies: red is the true visibility, green 255 where the pixel counts.
void pictures_path(char path[FILES_PATH], const char *output, const char *scene);

// Where the frame lies that was measured under this key: grey is the visibility.
void pictures_frame_path(char path[FILES_PATH], const char *output, uint64_t key);

// Writes a number in 0..1 a pixel as grey; with a mask of zeros and ones as red and blue, with the mask as
// green. False with a message.
bool pictures_write(const char *path, MetricsSize size, const float *numbers, const uint8_t *mask);
