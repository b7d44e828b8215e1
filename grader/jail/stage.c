// Copies our worker, shaders, headers and the jail's programs to a private folder, and removes it at the end.
#include "jail/stage.h"

#include "scene/check.h"
#include "scene/count.h"
#include "base/places.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct Part {
    const char *name;
    bool built;    // lies in the build folder
    bool optional; // need not be there
} Part;

static const Part parts[] = {{"worker", true, false},      {"worker_address", true, true},
                             {"jail_shim", true, false},   {"jail_probe", true, false},
                             {"jail_unpack", true, false}, {"include", true, false},
                             {"common", false, false},     {"shaders", false, false}};
enum { PARTS = COUNT(parts) };

void stage_source(const char *name, char path[FILES_PATH]) {
    int i = 0;
    while (i < PARTS && strcmp(parts[i].name, name) != 0)
        i++;
    INVARIANT(i < PARTS);
    if (parts[i].built)
        places_build_path(path, name);
    else
        places_path(path, name);
}

static bool copy_bytes(int from, int to, off_t size) {
    for (off_t done = 0; done < size;) {
        ssize_t n = sendfile(to, from, NULL, (size_t)(size - done));
        if (n <= 0)
            return false;
        done += n;
    }
    return true;
}

static bool copy_file(const char *from, const char *to, const struct stat *info) {
    int in = open(from, O_RDONLY | O_CLOEXEC);
    int out = open(to, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    bool ok = in >= 0 && out >= 0 && copy_bytes(in, out, info->st_size) &&
              fchmod(out, info->st_mode & S_IXUSR ? 0755 : 0644) == 0;
    if (!ok)
        check_fail("%s cannot be copied to %s for the jail: %s", from, to, strerror(errno));
    if (in >= 0)
        close(in);
    if (out >= 0)
        close(out);
    return ok;
}

typedef struct Copy {
    const char *from, *to;
    bool ok;
} Copy;

static void copy_entry(const char *name, void *context) {
    Copy *copy = context;
    char from[FILES_PATH], to[FILES_PATH];
    size_t length = strlen(name);
    if (!copy->ok || (length > 2 && strcmp(name + length - 2, ".c") == 0))
        return;
    files_join(from, copy->from, name);
    files_join(to, copy->to, name);
    copy->ok = stage_copy(from, to);
}

bool stage_copy(const char *from, const char *to) {
    struct stat info;
    if (stat(from, &info) != 0)
        return check_fail("%s cannot be copied for the jail: %s", from, strerror(errno));
    if (!S_ISDIR(info.st_mode))
        return copy_file(from, to, &info);
    Copy inner = {from, to, mkdir(to, 0755) == 0 && chmod(to, 0755) == 0};
    return inner.ok && files_list(from, copy_entry, &inner) && inner.ok;
}

bool stage_create(char stage[FILES_PATH]) {
    if (!files_make_temporary(stage))
        return false;
    bool ok = chmod(stage, 0755) == 0;
    for (int i = 0; ok && i < PARTS; i++) {
        char from[FILES_PATH], to[FILES_PATH];
        stage_source(parts[i].name, from);
        files_join(to, stage, parts[i].name);
        ok = (parts[i].optional && !files_exists(from)) || stage_copy(from, to);
    }
    if (!ok) {
        stage_destroy(stage);
        stage[0] = '\0';
    }
    return ok;
}

void stage_destroy(const char *stage) {
    if (stage[0])
        files_remove(stage);
}
