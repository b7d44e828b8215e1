#include "class/run_folder.h"

#include "scene/check.h"
#include "scene/count.h"
#include "base/files.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Removes what the link names, if it is a folder that files_make_temporary made for us.
static void remove_linked(const char *link) {
    char path[FILES_PATH];
    struct stat info;
    ssize_t length = readlink(link, path, sizeof path - 1);
    if (length <= 0)
        return;
    path[length] = '\0';
    const char *name = strrchr(path, '/');
    if (name && strncmp(name, "/shadow-lab-", 12) == 0 && lstat(path, &info) == 0 && S_ISDIR(info.st_mode) &&
        info.st_uid == geteuid())
        files_remove(path);
    unlink(link);
}

static void sweep(const char *output) {
    static const char *const folders[] = {".", "results", "pages", "rounds"};
    char path[FILES_PATH];
    for (size_t i = 0; i < COUNT(folders); i++) {
        files_join(path, output, folders[i]);
        files_forget_new(path);
    }
    files_join(path, output, "work");
    remove_linked(path);
    check_clear();
}

// Where temporary files went before the run; NULL: nobody said.
static char *place_before;
static bool moved;

static bool move_to(const char *path) {
    const char *place = getenv("TMPDIR");
    place_before = place ? strdup(place) : NULL;
    moved = setenv("TMPDIR", path, 1) == 0;
    return moved;
}

// What comes after the run needs temporary files, too.
static void move_back(void) {
    if (!moved)
        return;
    if (!place_before || setenv("TMPDIR", place_before, 1) != 0)
        unsetenv("TMPDIR");
    free(place_before);
    place_before = NULL;
    moved = false;
}

bool run_folder_create(const char *output) {
    char link[FILES_PATH], path[FILES_PATH];
    sweep(output);
    files_join(link, output, "work");
    if (!files_make_temporary(path))
        return false;
    bool ok = chmod(path, 0711) == 0 && symlink(path, link) == 0 && move_to(path);
    if (!ok) {
        check_fail("%s cannot be made: %s", link, strerror(errno));
        files_remove(path);
    }
    return ok;
}

void run_folder_destroy(const char *output) {
    sweep(output);
    move_back();
}
