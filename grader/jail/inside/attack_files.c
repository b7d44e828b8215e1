// The attacks on files: reading and writing what is not the submission's, by every way that we know.
#include "jail/inside/attacks.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

bool attack_read(const char *path) {
    char byte;
    int descriptor = open(path, O_RDONLY);
    bool done = descriptor >= 0 && read(descriptor, &byte, 1) == 1;
    if (descriptor >= 0)
        close(descriptor);
    return done;
}

bool attack_write(const char *folder, const char *name) {
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    int descriptor = open(path, O_WRONLY | O_CREAT, 0600);
    bool done = descriptor >= 0 && write(descriptor, "x", 1) == 1;
    if (descriptor >= 0)
        close(descriptor);
    return done;
}

static bool reads_secret(const AttackTarget *target) {
    return attack_read(target->secret);
}

static bool lists_solutions(const AttackTarget *target) {
    DIR *folder = opendir(target->solutions);
    if (folder)
        closedir(folder);
    return folder != NULL;
}

static bool reads_system(const AttackTarget *target) {
    (void)target;
    return attack_read("/etc/passwd") || attack_read("/dev/zero") || attack_read("/etc/hostname");
}

static bool reads_processes(const AttackTarget *target) {
    char path[64];
    snprintf(path, sizeof path, "/proc/%ld/cmdline", (long)target->grader);
    return attack_read(path) || attack_read("/proc/self/cmdline") || attack_read("/proc/1/cmdline");
}

static bool overwrites(const char *path, int flags) {
    int descriptor = open(path, flags);
    if (descriptor >= 0)
        close(descriptor);
    return descriptor >= 0;
}

static bool changes_submission(const AttackTarget *target) {
    return overwrites(target->visible, O_WRONLY) || overwrites(target->visible, O_RDONLY | O_TRUNC) ||
           truncate(target->visible, 0) == 0 || chmod(target->visible, 0777) == 0 ||
           utimensat(AT_FDCWD, target->visible, NULL, 0) == 0;
}

static bool changes_secret(const AttackTarget *target) {
    return overwrites(target->secret, O_WRONLY) || truncate(target->secret, 0) == 0 ||
           chmod(target->secret, 0777) == 0 || unlink(target->secret) == 0 ||
           rename(target->secret, target->visible) == 0;
}

static bool unlink_made(const char *folder) {
    char path[4096];
    snprintf(path, sizeof path, "%s/shadow-lab-attack", folder);
    unlink(path);
    return true;
}

static bool makes_files(const AttackTarget *target) {
    static const char *const folders[] = {"/", "/tmp", "/var/tmp", "/dev/shm", "/run", ".", "/home"};
    for (unsigned i = 0; i < sizeof folders / sizeof folders[0]; i++)
        if (attack_write(folders[i], "shadow-lab-attack"))
            return unlink_made(folders[i]);
    return !target->tools && attack_write(target->out, "attack");
}

static bool makes_links(const AttackTarget *target) {
    char path[4096];
    snprintf(path, sizeof path, "%s/link", target->out);
    return symlink(target->secret, path) == 0 || link(target->secret, path) == 0 || mkfifo(path, 0600) == 0 ||
           mkdir(path, 0700) == 0;
}

static bool mounts(const AttackTarget *target) {
    (void)target;
    return mount("none", "/tmp", "tmpfs", 0, NULL) == 0 || chroot(".") == 0 || umount2("/", MNT_DETACH) == 0;
}

static bool opens_by_handle(const AttackTarget *target) {
    struct file_handle handle = {.handle_bytes = 0};
    (void)target;
    return open_by_handle_at(AT_FDCWD, &handle, O_RDONLY) >= 0 || errno != EPERM;
}

static bool inherits_files(const AttackTarget *target) {
    (void)target;
    for (int descriptor = 4; descriptor < 64; descriptor++)
        if (fcntl(descriptor, F_GETFD) >= 0)
            return true;
    return false;
}

const Attack attacks_on_files[] = {
    {"reading a file that is not the submission's", reads_secret, false, false},
    {"listing the solutions", lists_solutions, false, false},
    {"reading the system's files", reads_system, false, false},
    {"reading /proc", reads_processes, false, true},
    {"changing the submission", changes_submission, false, false},
    {"changing somebody's file", changes_secret, false, false},
    {"making a file", makes_files, false, false},
    {"making a link, a pipe or a folder", makes_links, false, false},
    {"mounting", mounts, false, false},
    {"opening by handle", opens_by_handle, false, false},
    {"inheriting a descriptor", inherits_files, false, false},
    {0}};
