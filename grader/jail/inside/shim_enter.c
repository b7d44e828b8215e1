// Namespaces by one clone3, mounts by the kernel's own calls; each step that fails ends the process.
#include "jail/inside/shim_enter.h"

#include "jail/inside/shim_files.h"
#include "jail/inside/shim_filter.h"
#include "jail/inside/shim_limit.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <linux/sched.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

// Where the new root is put together: of /proc nothing is needed any more, and it is everywhere.
static const char ROOT[] = "/proc";

enum { PATH_ROOM = 4096, FIRST_FOREIGN = 4, LAST_CAPABILITY = 63 };

pid_t shim_enter_fork(void) {
    uint64_t *thread = NULL; // where the C library keeps the number of the thread
    if (prctl(PR_GET_TID_ADDRESS, &thread) != 0)
        return -1;
    struct clone_args how = {.flags = CLONE_PARENT | CLONE_NEWUSER | CLONE_NEWNS | CLONE_NEWPID |
                                      CLONE_NEWIPC | CLONE_NEWNET | CLONE_NEWUTS | CLONE_NEWCGROUP |
                                      CLONE_CHILD_SETTID | CLONE_CHILD_CLEARTID,
                             .child_tid = (uint64_t)(uintptr_t)thread};
    return (pid_t)syscall(SYS_clone3, &how, sizeof how);
}

static void say(const char *path, const char *text) {
    const int file = open(path, O_WRONLY | O_CLOEXEC);
    if (file < 0 || write(file, text, strlen(text)) != (ssize_t)strlen(text))
        shim_fail(path);
    close(file);
}

static void stay(const ShimOwner *owner) {
    char text[64];
    say("/proc/self/setgroups", "deny");
    snprintf(text, sizeof text, "%u %u 1", (unsigned)owner->group, (unsigned)owner->group);
    say("/proc/self/gid_map", text);
    snprintf(text, sizeof text, "%u %u 1", (unsigned)owner->user, (unsigned)owner->user);
    say("/proc/self/uid_map", text);
}

// Makes the folders above the path's last part.
static void make_parents(char *path, size_t from) {
    for (char *slash = strchr(path + from, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        if (mkdir(path, 0755) != 0 && errno != EEXIST)
            shim_fail(path);
        *slash = '/';
    }
}

// On a merged system /lib is a link to usr/lib, and stays one.
static void copy_link(const char *path, const char *to) {
    char target[PATH_ROOM];
    const ssize_t length = readlink(path, target, sizeof target - 1);
    target[length < 0 ? 0 : length] = '\0';
    if (length < 0 || symlink(target, to) != 0)
        shim_fail(path);
}

static void mount_read_only(const char *path, const char *to) {
    struct mount_attr attributes = {.attr_set = MOUNT_ATTR_RDONLY | MOUNT_ATTR_NOSUID | MOUNT_ATTR_NODEV};
    if (mount(path, to, NULL, MS_BIND | MS_REC, NULL) != 0 ||
        syscall(SYS_mount_setattr, AT_FDCWD, to, AT_RECURSIVE, &attributes, sizeof attributes) != 0)
        shim_fail(path);
}

static void show(const char *path) {
    char to[PATH_ROOM];
    struct stat info;
    if (snprintf(to, sizeof to, "%s%s", ROOT, path) >= (int)sizeof to || lstat(path, &info) != 0)
        shim_fail(path);
    make_parents(to, sizeof ROOT);
    if (S_ISLNK(info.st_mode)) {
        copy_link(path, to);
        return;
    }
    const int file = S_ISDIR(info.st_mode) ? -1 : open(to, O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    if (S_ISDIR(info.st_mode) ? mkdir(to, 0755) != 0 && errno != EEXIST : file < 0)
        shim_fail(path);
    if (file >= 0)
        close(file);
    mount_read_only(path, to);
}

static void leave_files(const ShimPlan *plan, const char *folder) {
    if (mount(NULL, "/", NULL, MS_REC | MS_PRIVATE, NULL) != 0 ||
        mount("tmpfs", ROOT, "tmpfs", MS_NOSUID | MS_NODEV, "size=1m,mode=755") != 0)
        shim_fail("mounts");
    for (int i = 0; i < plan->readable_count; i++)
        show(plan->readable[i]);
    if (chdir(ROOT) != 0 || syscall(SYS_pivot_root, ".", ".") != 0 || umount2(".", MNT_DETACH) != 0 ||
        mount(NULL, "/", NULL, MS_REMOUNT | MS_BIND | MS_RDONLY | MS_NOSUID | MS_NODEV, NULL) != 0 ||
        chdir(folder) != 0)
        shim_fail("the old files");
}

// Whose machine it is, is told to nobody inside.
static void leave_names(void) {
    static const char name[] = "shadow-lab"; // as bwrap_command has it
    if (sethostname(name, sizeof name - 1) != 0 || setdomainname("", 0) != 0)
        shim_fail("names");
}

static void leave_capabilities(void) {
    struct __user_cap_header_struct header = {.version = _LINUX_CAPABILITY_VERSION_3};
    struct __user_cap_data_struct none[2] = {{0}};
    for (int i = 0; i <= LAST_CAPABILITY; i++)
        prctl(PR_CAPBSET_DROP, i, 0, 0, 0); // those that this kernel does not know are not there
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
        prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0) != 0 ||
        syscall(SYS_capset, &header, none) != 0)
        shim_fail("capabilities");
}

// Ends as its child does, and as bwrap tells it. Group signals are meant for the child.
static _Noreturn void watch(pid_t child) {
    pid_t ended;
    int status = 0;
    for (int number = 1; number < NSIG; number++)
        signal(number, number == SIGCHLD ? SIG_DFL : SIG_IGN);
    close_range(0, ~0u, 0);
    while ((ended = waitpid(-1, &status, 0)) != child && (ended > 0 || errno == EINTR))
        ;
    _exit(WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status));
}

// Number 1 is not ended by signals of its own, so that an abort would go on: the process is number 2.
static void become_second(void) {
    const pid_t child = fork();
    if (child < 0)
        shim_fail("a second process");
    if (child > 0)
        watch(child);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
}

void shim_enter(const ShimPlan *plan, const char *folder, const ShimOwner *owner) {
    close_range(FIRST_FOREIGN, ~0u, 0);
    stay(owner);
    leave_files(plan, folder);
    leave_names();
    leave_capabilities();
    become_second();
    shim_limit(plan);
    shim_hide_files(plan);
    shim_filter(plan);
}
