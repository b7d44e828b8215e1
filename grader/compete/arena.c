// Reads arena.json and the scenes beside it, which record_arena has written.
#include "compete/arena.h"

#include "points/recorded_scene.h"
#include "points/recorded_study.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void arena_index(char path[FILES_PATH], const char *folder) {
    files_join(path, folder, "arena.json");
}

void arena_camera(char name[ARENA_TEXT], int camera) {
    snprintf(name, ARENA_TEXT, "camera-%d", camera + 1);
}

static bool take_setting(ArenaSetting *setting, json_t *entry) {
    json_t *knobs;
    return json_unpack(entry, "{s:s, s:s, s:o}", "name", &setting->name, "view", &setting->view, "knobs",
                       &knobs) == 0 &&
           recorded_study_knobs(setting->knobs, &setting->knob_count, knobs);
}

static bool take_all(Arena *arena, const char **lab) {
    json_t *settings, *entry;
    const char *seed;
    size_t i;
    if (json_unpack(arena->json, "{s:s, s:s, s:s, s:F, s:o}", "lab", lab, "seed", &seed, "scene",
                    &arena->scene, "most error", &arena->most_error, "settings", &settings) != 0)
        return false;
    arena->seed = strtoull(seed, NULL, 10);
    json_array_foreach(settings, i, entry) {
        if (arena->setting_count == ARENA_SETTINGS ||
            !take_setting(&arena->settings[arena->setting_count++], entry))
            return false;
    }
    return arena->setting_count > 0;
}

static bool read_cameras(Arena *arena, const char *folder) {
    char name[ARENA_TEXT];
    for (int i = 0; i < ARENA_CAMERAS; i++) {
        arena_camera(name, i);
        if (!recorded_scene_read(folder, name, &arena->scenes[i], ARENA_WIDTH, ARENA_HEIGHT,
                                 &arena->truths[i]))
            return false;
    }
    return true;
}

bool arena_read(Arena *arena, const char *folder, const char *lab) {
    char path[FILES_PATH];
    const char *of = "";
    *arena = (Arena){0};
    arena_index(path, folder);
    if (!files_exists(path))
        return check_fail("%s is missing: lab %s has no contest here", path, lab);
    arena->json = json_load_file(path, 0, NULL);
    const bool whole = arena->json && take_all(arena, &of);
    bool ok = whole || check_fail("%s is not whole: make it again", path);
    ok = ok && (strcmp(of, lab) == 0 || check_fail("%s is of lab %.2s, not of lab %s", path, of, lab)) &&
         read_cameras(arena, folder);
    snprintf(arena->lab, sizeof arena->lab, "%s", lab);
    if (!ok)
        arena_destroy(arena);
    return ok;
}

void arena_destroy(Arena *arena) {
    for (int i = 0; i < ARENA_CAMERAS; i++)
        image_destroy(&arena->truths[i]);
    json_decref(arena->json);
    *arena = (Arena){0};
}
