// Reads and writes whole files: of ours, of strangers (never through a link), and so that a file is there
// whole or not at all; makes, lists and removes folders.
#include "base/files.h"

#include "scene/check.h"
#include "base/temporary.h"
#include "base/text_check.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <limits.h>
#include <linux/openat2.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

static char *read_all(int descriptor, const char *path, size_t limit, size_t *size) {
    struct stat info;
    if (fstat(descriptor, &info) != 0 || !S_ISREG(info.st_mode)) {
        check_fail("%s is not a regular file", path);
        return NULL;
    }
    if ((size_t)info.st_size > limit) {
        check_fail("%s is larger than %zu KiB", path, limit / 1024);
        return NULL;
    }
    char *text = calloc((size_t)info.st_size + 1, 1);
    for (*size = 0; text && *size < (size_t)info.st_size;) {
        ssize_t n = read(descriptor, text + *size, (size_t)info.st_size - *size);
        if (n <= 0)
            break;
        *size += (size_t)n;
    }
    return text;
}

char *files_read_bytes(const char *path, size_t limit, size_t *size) {
    int descriptor = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) {
        check_fail("%s cannot be read: %s", path, strerror(errno));
        return NULL;
    }
    char *bytes = read_all(descriptor, path, limit, size);
    close(descriptor);
    return bytes;
}

char *files_read(const char *path, size_t limit) {
    size_t size;
    return files_read_bytes(path, limit, &size);
}

static int open_folder(const char *folder) {
    struct stat info;
    int at = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
    if (at < 0) {
        int reason = errno;
        bool link = lstat(folder, &info) == 0 && S_ISLNK(info.st_mode);
        check_fail(link ? "%s is a symbolic link: hand in the folder itself" : "folder %s cannot be read: %s",
                   folder, strerror(reason));
    }
    return at;
}

bool files_is_folder(const char *path) {
    struct stat info;
    return lstat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

bool files_check_folder(const char *path) {
    int at = open_folder(path);
    if (at >= 0)
        close(at);
    return at >= 0;
}

static int open_untrusted(const char *folder, const char *name) {
    struct open_how how = {.flags = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW,
                           .resolve = RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS |
                                      RESOLVE_NO_XDEV};
    int at = open_folder(folder);
    if (at < 0)
        return -1;
    int descriptor = (int)syscall(SYS_openat2, at, name, &how, sizeof how);
    if (descriptor < 0)
        check_fail(errno == ELOOP ? "%s is a symbolic link: hand in the file itself"
                                  : "%s cannot be read: %s",
                   name, strerror(errno));
    close(at);
    return descriptor;
}

static char *read_untrusted(const char *folder, const char *name, size_t limit, size_t *size) {
    struct stat info;
    char *text = NULL;
    int descriptor = open_untrusted(folder, name);
    if (descriptor < 0)
        return NULL;
    if (fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode) && info.st_nlink != 1)
        check_fail("%s is a hard link to another file: hand in a copy", name);
    else
        text = read_all(descriptor, name, limit, size);
    close(descriptor);
    return text;
}

char *files_read_untrusted(const char *folder, const char *name, size_t limit) {
    size_t size;
    char *text = read_untrusted(folder, name, limit, &size);
    if (text && text_check(text, size, name))
        return text;
    free(text);
    return NULL;
}

bool files_take(const char *folder, const char *name, const char *path, size_t limit) {
    size_t size;
    char *bytes = read_untrusted(folder, name, limit, &size);
    if (!bytes)
        return false;
    int file = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    bool ok = file >= 0 && write(file, bytes, size) == (ssize_t)size;
    if (file >= 0)
        ok = close(file) == 0 && ok;
    free(bytes);
    return ok || check_fail("%s cannot be written: %s", path, strerror(errno));
}

bool files_write(const char *path, const char *text) {
    FILE *file = fopen(path, "w");
    bool ok = file && fputs(text, file) >= 0;
    if (file && fclose(file) != 0)
        ok = false;
    return ok || check_fail("%s cannot be written: %s", path, strerror(errno));
}

// Does the file already hold just these bytes?
static bool holds(const char *path, const void *bytes, size_t size) {
    FILE *file = fopen(path, "rb");
    char *old = malloc(size + 1);
    bool same = file && old && fread(old, 1, size + 1, file) == size && memcmp(old, bytes, size) == 0;
    free(old);
    if (file)
        fclose(file);
    return same;
}

bool files_write_changed(const char *path, const void *bytes, size_t size, bool *changed) {
    *changed = !holds(path, bytes, size);
    if (!*changed)
        return true;
    FILE *file = fopen(path, "wb");
    bool ok = file && fwrite(bytes, 1, size, file) == size;
    if (file && fclose(file) != 0)
        ok = false;
    return ok || check_fail("%s cannot be written: %s", path, strerror(errno));
}

static bool write_synced(int descriptor, const char *text) {
    size_t size = strlen(text), done = 0;
    while (done < size) {
        ssize_t n = write(descriptor, text + done, size - done);
        if (n < 0 && errno != EINTR)
            return false;
        done += n > 0 ? (size_t)n : 0;
    }
    return fsync(descriptor) == 0;
}

void files_folder_of(char folder[FILES_PATH], const char *path) {
    const char *slash = strrchr(path, '/');
    if (slash)
        snprintf(folder, FILES_PATH, "%.*s", (int)(slash - path + 1), path);
    else
        snprintf(folder, FILES_PATH, "./");
}

// The name of a file outlives a loss of power only when its folder was synced, too.
bool files_sync_folder(const char *folder) {
    int descriptor = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    bool ok = descriptor >= 0 && (fsync(descriptor) == 0 || errno == EINVAL);
    if (descriptor >= 0)
        close(descriptor);
    return ok;
}

static bool put(const char *aside, const char *path, bool replace) {
    if (replace)
        return rename(aside, path) == 0;
    bool ok = link(aside, path) == 0 || errno == EEXIST;
    unlink(aside);
    return ok;
}

bool files_write_whole(const char *path, const char *text, bool replace) {
    char folder[FILES_PATH], aside[FILES_PATH];
    files_folder_of(folder, path);
    files_join(aside, folder, FILES_NEW "XXXXXX");
    int descriptor = mkostemp(aside, O_CLOEXEC);
    bool ok = descriptor >= 0 && fchmod(descriptor, 0644) == 0 && write_synced(descriptor, text);
    if (descriptor >= 0 && close(descriptor) != 0)
        ok = false;
    ok = ok && put(aside, path, replace) && files_sync_folder(folder);
    if (!ok) {
        check_fail("%s cannot be written: %s", path, strerror(errno));
        unlink(aside);
    }
    return ok;
}

static void forget_new(const char *name, void *context) {
    char path[FILES_PATH];
    files_join(path, context, name);
    if (strncmp(name, FILES_NEW, strlen(FILES_NEW)) == 0)
        unlink(path);
}

void files_forget_new(const char *folder) {
    files_list(folder, forget_new, (void *)folder);
}

bool files_exists(const char *path) {
    return access(path, F_OK) == 0;
}

bool files_make_temporary(char path[FILES_PATH]) {
    const char *parent = getenv("TMPDIR");
    char whole[PATH_MAX];
    if (!realpath(parent ? parent : "/tmp", whole))
        return check_fail("no temporary folder %s: %s", parent ? parent : "/tmp", strerror(errno));
    files_join(path, whole, "shadow-lab-XXXXXX");
    if (!mkdtemp(path))
        return check_fail("no temporary folder %s: %s", path, strerror(errno));
    temporary_add(path);
    return true;
}

bool files_make_folder(const char *path) {
    char partial[FILES_PATH];
    files_join(partial, path, "");
    for (char *slash = strchr(partial + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        if (mkdir(partial, 0777) != 0 && errno != EEXIST)
            return check_fail("folder %s cannot be made: %s", partial, strerror(errno));
        *slash = '/';
    }
    return true;
}

static int remove_entry(const char *path, const struct stat *info, int kind, struct FTW *position) {
    (void)info, (void)kind, (void)position;
    return remove(path);
}

static int remove_inner(const char *path, const struct stat *info, int kind, struct FTW *position) {
    (void)info, (void)kind;
    return position->level > 0 ? remove(path) : 0;
}

void files_empty(const char *path) {
    nftw(path, remove_inner, 16, FTW_DEPTH | FTW_PHYS);
}

void files_remove(const char *path) {
    nftw(path, remove_entry, 16, FTW_DEPTH | FTW_PHYS);
    temporary_drop(path);
}

void files_join(char path[FILES_PATH], const char *a, const char *b) {
    int length = snprintf(path, FILES_PATH, "%s/%s", a, b);
    INVARIANT(length >= 0 && length < FILES_PATH);
}

static int visible(const struct dirent *entry) {
    return strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
}

static int by_bytes(const struct dirent **a, const struct dirent **b) {
    return strcmp((*a)->d_name, (*b)->d_name);
}

bool files_list(const char *folder, void (*visit)(const char *name, void *context), void *context) {
    struct dirent **entries;
    int count = scandir(folder, &entries, visible, by_bytes);
    if (count < 0)
        return check_fail("folder %s cannot be read: %s", folder, strerror(errno));
    for (int i = 0; i < count; i++) {
        visit(entries[i]->d_name, context);
        free(entries[i]);
    }
    free(entries);
    return true;
}
