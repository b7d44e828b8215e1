#include "exam/handed_out.h"

#include "base/files.h"
#include "base/places.h"
#include "compile/lab_folder.h"

#include <stdio.h>
#include <string.h>

bool handed_out_alone(void) {
    char solutions[FILES_PATH], recorded[FILES_PATH];
    places_path(solutions, "solutions");
    places_path(recorded, "grader/recorded/seeds.json");
    return !files_exists(solutions) && files_exists(recorded);
}

// Where a file that students get lies: as they get it, where there are no solutions.
static void place_handed_out(char path[FILES_PATH], const Rubric *rubric, const char *name) {
    char folder[FILES_PATH];
    snprintf(folder, sizeof folder, "%s", rubric->folder);
    if (handed_out_alone()) {
        places_path(path, "grader/recorded/labs");
        files_join(folder, path, strrchr(rubric->folder, '/') + 1);
    }
    files_join(path, folder, name);
}

bool handed_out_has(const Rubric *rubric, const char *name) {
    char path[FILES_PATH];
    if (strlen(name) > 200)
        return false;
    place_handed_out(path, rubric, name);
    return files_exists(path);
}

char *handed_out_text(const Rubric *rubric, int i) {
    char path[FILES_PATH];
    if (!handed_out_alone())
        return lab_folder_source(rubric, i, (Solved){SOLVED_NONE, NULL});
    place_handed_out(path, rubric, rubric->files[i]);
    return files_read(path, DERIVE_MAX_FILE);
}
