#include "study/study_scene.h"

#include "scene/check.h"
#include "truth/closed_scenes.h"

#include <string.h>

const int study_sizes[STUDY_SIZES] = {256, 512, 1024, 2048, 4096};

void study_add_turned(Scene *scene, Shape shape, vec3s center, vec3s half_size, float turn) {
    closed_add(scene, shape, center, half_size, 0);
    mat4s turned = glms_rotate(glms_translate_make(center), glm_rad(turn), vec3_make(0, 0, 1));
    scene->objects[scene->object_count - 1].world_from_object = glms_scale(turned, half_size);
}

void study_look(Scene *scene, vec3s eye, vec3s target) {
    scene->camera =
        (Camera){.eye = eye, .target = target, .fov_y = glm_rad(40), .near_plane = 0.5f, .far_plane = 60};
}

const StudyScene *study_scene(int i) {
    for (int lab = 0; study_tables[lab]; lab++)
        for (const StudyScene *scene = study_tables[lab]->scenes; scene && scene->name; scene++)
            if (i-- == 0)
                return scene;
    return NULL;
}

const StudyScene *study_scene_named(const char *name) {
    for (int i = 0; study_scene(i); i++)
        if (strcmp(study_scene(i)->name, name) == 0)
            return study_scene(i);
    return NULL;
}

const StudyContest *study_contest(const char *lab) {
    for (int i = 0; study_tables[i]; i++)
        if (study_tables[i]->contest.lab && strcmp(study_tables[i]->contest.lab, lab) == 0)
            return &study_tables[i]->contest;
    check_fail("lab %s has no contest: its study.c names no scene for one", lab);
    return NULL;
}

void study_settle(Scene *scene, const StudyScene *of) {
    for (int lab = 0; study_tables[lab]; lab++)
        if (study_tables[lab]->settle)
            study_tables[lab]->settle(scene, of->name);
}

int study_count_objects(const StudyScene *scene) {
    static Scene made;
    scene->make(&made);
    return made.object_count;
}

void study_add_methods(MethodList *list, const StudyScene *scene) {
    list->count = 0;
    for (int lab = 0; study_tables[lab]; lab++)
        study_tables[lab]->add_methods(list, scene->name);
}
