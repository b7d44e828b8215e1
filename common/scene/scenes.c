// Scenes. Each holds only what shows its phenomenon; what varies is drawn from a seed, so that a picture of
// one variant is worth nothing in another.
#include "scene/check.h"
#include "scene/palette.h"
#include "scene/scene_parts.h"

#include <string.h>

static const SceneMaker *find(int i) {
    for (int table = 0; scenes_tables[table]; table++)
        for (const SceneMaker *maker = scenes_tables[table]; maker->name; maker++)
            if (i-- == 0)
                return maker;
    return NULL;
}

const char *scene_name(int i) {
    const SceneMaker *maker = find(i);
    return maker ? maker->name : NULL;
}

bool scene_make(Scene *scene, const char *name, Random *random) {
    char names[2048] = "";
    for (int i = 0; find(i); i++) {
        if (strcmp(find(i)->name, name) == 0) {
            find(i)->make(scene, random);
            palette_vary(scene, &(Random){~random->state}); // takes nothing from what is drawn after it
            return medium_check(&scene->medium) && scene_check(scene);
        }
        check_append(names, sizeof names, "%s\"%s\"", i ? ", " : "", find(i)->name);
    }
    return check_fail("there is no scene \"%s\"; the scenes are %s", name, names);
}
