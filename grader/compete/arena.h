// Where methods compete: a scene from several cameras with their truths, the settings that a lab is tried in,
// and how much a method may err. record_arena writes it; it lies in a folder of its own.
#pragma once

#include "base/files.h"
#include "protocol/protocol.h"
#include "scene/image.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdint.h>

enum { ARENA_CAMERAS = 4, ARENA_WIDTH = 320, ARENA_HEIGHT = 240, ARENA_SETTINGS = 40, ARENA_TEXT = 64 };

typedef struct ArenaSetting {
    const char *name, *view; // the arena's
    KnobSetting knobs[LAB_MAX_KNOBS];
    int knob_count;
} ArenaSetting;

typedef struct Arena {
    char lab[3];
    uint64_t seed;     // of the cameras
    double most_error; // 0..1, the mean of all cameras
    const char *scene; // its name
    ArenaSetting settings[ARENA_SETTINGS];
    int setting_count;
    Scene scenes[ARENA_CAMERAS];
    Image truths[ARENA_CAMERAS]; // as recorded_scene.h has them, ARENA_WIDTH x ARENA_HEIGHT
    json_t *json;                // where the strings live
} Arena;

// Where arena.json lies in the folder, and the name of a camera's files there.
void arena_index(char path[FILES_PATH], const char *folder);
void arena_camera(char name[ARENA_TEXT], int camera);

// Reads an arena of this lab from its folder. False with a message.
bool arena_read(Arena *arena, const char *folder, const char *lab);
void arena_destroy(Arena *arena); // accepts a zeroed arena
