#include "study/scene_list.h"

#include "study/study_scene.h"

#include <string.h>

static bool is_new(const MethodList *list, int i) {
    for (int earlier = 0; earlier < i; earlier++)
        if (strcmp(list->methods[earlier].family, list->methods[i].family) == 0 &&
            strcmp(list->methods[earlier].lab, list->methods[i].lab) == 0)
            return false;
    return true;
}

static void write_families(FILE *file, const StudyScene *scene) {
    static MethodList list;
    const char *before = "\t";
    study_add_methods(&list, scene);
    for (int i = 0; i < list.count; i++)
        if (is_new(&list, i)) {
            fprintf(file, "%s%s (%s)", before, list.methods[i].family, list.methods[i].lab);
            before = "; ";
        }
}

void scene_list_write(FILE *file) {
    for (int i = 0; study_scene(i); i++) {
        fprintf(file, "%s\t%d\t%s", study_scene(i)->name, study_count_objects(study_scene(i)),
                study_scene(i)->title);
        write_families(file, study_scene(i));
        fputc('\n', file);
    }
}
