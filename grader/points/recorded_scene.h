// A scene and its truth in two files: NAME.scene, and NAME.png (see README.md).
#pragma once

#include "scene/image.h"
#include "scene/scene.h"

#include <stdbool.h>
#include <stdint.h>

// Writes folder/NAME.scene and folder/NAME.png: the light that reaches each pixel, 0..1, and where it counts
// (1); both have width x height entries, top row first. False with a message.
bool recorded_scene_write(const char *folder, const char *name, const Scene *scene, int width, int height,
                          const float *visibility, const uint8_t *mask);

// Reads both; a truth that was there is freed. False with a message, also where they do not fit this version
// or another size.
bool recorded_scene_read(const char *folder, const char *name, Scene *scene, int width, int height,
                         Image *truth);
