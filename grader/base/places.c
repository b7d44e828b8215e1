#include "base/places.h"

#include "scene/check.h"

#include <ctype.h>
#include <libgen.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const char *program_folder(void) {
    static char path[FILES_PATH]; // found at the first call
    if (!path[0]) {
        ssize_t length = readlink("/proc/self/exe", path, sizeof path - 1);
        INVARIANT(length > 0);
        dirname(path);
    }
    return path;
}

void places_build_path(char path[FILES_PATH], const char *name) {
    files_join(path, program_folder(), name);
}

void places_path(char path[FILES_PATH], const char *relative) {
    char root[FILES_PATH];
    snprintf(root, sizeof root, "%s", program_folder());
    files_join(path, dirname(root), relative);
}

bool places_is_lab_name(const char *name) {
    return isdigit((unsigned char)name[0]) && isdigit((unsigned char)name[1]) && name[2] == '-';
}

typedef struct Search {
    const char *parent, *id;
    char *path;
    bool found;
} Search;

static void match(const char *name, void *context) {
    Search *search = context;
    if (search->found || !places_is_lab_name(name) || strncmp(name, search->id, 2) != 0)
        return;
    files_join(search->path, search->parent, name);
    search->found = true;
}

bool places_find_lab_in(char path[FILES_PATH], const char *parent, const char *id) {
    Search search = {.parent = parent, .id = id, .path = path};
    return files_list(parent, match, &search) && search.found;
}

void places_lab_of(char path[FILES_PATH], const char *parent, const char *id) {
    if (!places_find_lab_in(path, parent, id))
        files_join(path, parent, ".");
}

// Where the labs' rubrics lie.
static void labs_folder(char path[FILES_PATH]) {
    places_path(path, "solutions");
    if (!files_exists(path))
        places_path(path, "grader/recorded");
}

bool places_find_lab(char path[FILES_PATH], const char *id) {
    char labs[FILES_PATH];
    labs_folder(labs);
    return places_find_lab_in(path, labs, id);
}

typedef struct Walk {
    const char *labs;
    char last[3]; // id
    bool ok;
    void (*visit)(const char *id, void *context);
    void *context;
} Walk;

static void visit_lab(const char *name, void *context) {
    Walk *walk = context;
    if (!places_is_lab_name(name) || !walk->ok)
        return;
    const char id[3] = {name[0], name[1], '\0'};
    if (strcmp(id, walk->last) == 0) {
        walk->ok = check_fail("%s holds two folders of lab %s; rename one", walk->labs, id);
        return;
    }
    memcpy(walk->last, id, sizeof id);
    walk->visit(id, walk->context);
}

bool places_list_labs(void (*visit)(const char *id, void *context), void *context) {
    char labs[FILES_PATH];
    labs_folder(labs);
    Walk walk = {.labs = labs, .ok = true, .visit = visit, .context = context};
    return files_list(labs, visit_lab, &walk) && walk.ok &&
           (walk.last[0] || check_fail("there is no lab in %s", labs));
}
