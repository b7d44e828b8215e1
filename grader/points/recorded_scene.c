#include "points/recorded_scene.h"

#include "base/files.h"
#include "scene/check.h"

#include <math.h>
#include <stdio.h>

static void place(char path[FILES_PATH], const char *folder, const char *name, const char *end) {
    char file[128];
    snprintf(file, sizeof file, "%.100s.%s", name, end);
    files_join(path, folder, file);
}

static bool write_truth(const char *path, int width, int height, const float *visibility,
                        const uint8_t *mask) {
    Image truth;
    if (!image_create(&truth, width, height))
        return false;
    for (size_t i = 0; i < (size_t)width * (size_t)height; i++) {
        const long light = lrintf(65535 * fminf(fmaxf(visibility[i], 0), 1));
        truth.rgba[4 * i] = (uint8_t)(light >> 8);
        truth.rgba[4 * i + 1] = (uint8_t)(light & 255);
        truth.rgba[4 * i + 2] = mask[i] ? 255 : 0;
    }
    const bool ok = image_write_png(&truth, path);
    image_destroy(&truth);
    return ok;
}

bool recorded_scene_write(const char *folder, const char *name, const Scene *scene, int width, int height,
                          const float *visibility, const uint8_t *mask) {
    char path[FILES_PATH];
    place(path, folder, name, "png");
    if (!write_truth(path, width, height, visibility, mask))
        return false;
    place(path, folder, name, "scene");
    FILE *file = fopen(path, "wb");
    bool ok = file && fwrite(scene, sizeof *scene, 1, file) == 1;
    ok = file && fclose(file) == 0 && ok;
    return ok || check_fail("%s cannot be written", path);
}

static bool read_scene(Scene *scene, const char *path) {
    FILE *file = fopen(path, "rb");
    const bool ok = file && fread(scene, sizeof *scene, 1, file) == 1 && fgetc(file) == EOF &&
                    scene->object_count >= 0 && scene->object_count <= SCENE_MAX_OBJECTS &&
                    scene->light_count >= 0 && scene->light_count <= SCENE_MAX_LIGHTS;
    if (file)
        fclose(file);
    return ok || check_fail("%s is no scene of this version: unpack the kit again", path);
}

bool recorded_scene_read(const char *folder, const char *name, Scene *scene, int width, int height,
                         Image *truth) {
    char path[FILES_PATH];
    place(path, folder, name, "scene");
    if (!read_scene(scene, path) || !scene_check(scene))
        return false;
    place(path, folder, name, "png");
    image_destroy(truth);
    return image_read_png(truth, path) &&
           ((truth->width == width && truth->height == height) ||
            check_fail("%s has another size than what lies beside it says: unpack the kit again", path));
}
