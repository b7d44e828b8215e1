// Puts the command line together: bwrap with its mounts where that is the route, then the shim with its
// limits, then the program.
#include "jail/bwrap_command.h"

#include "scene/check.h"
#include "scene/count.h"

#include <sys/stat.h>
#include <unistd.h>

typedef struct SystemPath {
    const char *path;
    JailKind kind; // the first kind that needs it
} SystemPath;

// What a process inside sees of the system, where it exists. Never a folder that may hold our own sources,
// and no /proc, /dev, /home.
static const SystemPath system_paths[] = {
    {"/usr/lib", JAIL_DRAW},         {"/usr/lib64", JAIL_DRAW},
    {"/usr/local/lib", JAIL_DRAW},   {"/lib", JAIL_DRAW},
    {"/lib64", JAIL_DRAW},           {"/etc/ld.so.cache", JAIL_DRAW},
    {"/usr/share/glvnd", JAIL_DRAW}, {"/usr/share/drirc.d", JAIL_DRAW},
    {"/usr/bin", JAIL_TOOLS},        {"/bin", JAIL_TOOLS},
    {"/usr/local/bin", JAIL_TOOLS},  {"/usr/libexec", JAIL_TOOLS},
    {"/usr/include", JAIL_TOOLS},    {"/usr/local/include", JAIL_TOOLS}};
enum { SYSTEM_PATHS = COUNT(system_paths) };

#if defined(__SANITIZE_ADDRESS__)
enum { SANITIZED = true }; // then each process asks /proc for its stack
#else
enum { SANITIZED = false };
#endif

static void add(BwrapCommand *command, const char *argument) {
    INVARIANT(command->count < COMMAND_MAX - 1);
    command->arguments[command->count++] = (char *)argument;
    command->arguments[command->count] = NULL;
}

static void add_option(BwrapCommand *command, const char *option, const char *path) {
    add(command, option);
    add(command, path);
}

static void add_mount(BwrapCommand *command, const char *option, const char *path) {
    add_option(command, option, path);
    add(command, path);
}

// On a merged system /lib is a link to usr/lib, and stays one.
static void add_system_mount(BwrapCommand *command, const char *path, int *links) {
    struct stat info;
    if (lstat(path, &info) != 0)
        return;
    if (!S_ISLNK(info.st_mode)) {
        add_mount(command, "--ro-bind", path);
        return;
    }
    INVARIANT(*links < (int)COUNT(command->links));
    char *target = command->links[(*links)++];
    ssize_t length = readlink(path, target, sizeof command->links[0] - 1);
    INVARIANT(length > 0);
    target[length] = '\0';
    add_option(command, "--symlink", target);
    add(command, path);
}

static void add_bwrap(BwrapCommand *command, const Jail *jail, const JailPlan *plan) {
    // Never --new-session: all must stay in the process's group, by which it is ended.
    static const char *const first[] = {
        "bwrap",         "--unshare-user",       "--unshare-ipc",     "--unshare-pid", "--unshare-net",
        "--unshare-uts", "--unshare-cgroup-try", "--die-with-parent", "--hostname",    "shadow-lab"};
    int links = 0;
    for (unsigned i = 0; i < COUNT(first); i++)
        add(command, first[i]);
    for (int i = 0; i < SYSTEM_PATHS; i++)
        if (system_paths[i].kind <= plan->kind)
            add_system_mount(command, system_paths[i].path, &links);
    add_mount(command, "--ro-bind", jail->stage);
    add_mount(command, "--ro-bind", plan->folder);
    if (plan->readable)
        add_mount(command, "--ro-bind", plan->readable);
    if (plan->writable)
        add_mount(command, "--bind", plan->writable);
    if (SANITIZED || plan->sees_itself)
        add_option(command, "--proc", "/proc");
    add_option(command, "--remount-ro", "/");
    add_option(command, "--chdir", plan->folder);
    add(command, "--");
}

static void add_shim(BwrapCommand *command, const Jail *jail, const JailPlan *plan) {
    jail_part(jail, "jail_shim", command->shim);
    add(command, command->shim);
    if (plan->kind == JAIL_TOOLS)
        add(command, "-c");
    if (jail->route == JAIL_LANDLOCK)
        add(command, "-l");
    for (int i = 0; i < SYSTEM_PATHS; i++)
        if (system_paths[i].kind <= plan->kind && access(system_paths[i].path, F_OK) == 0)
            add_option(command, "-r", system_paths[i].path);
    add_option(command, "-r", jail->stage);
    add_option(command, "-r", plan->folder);
    if (plan->readable)
        add_option(command, "-r", plan->readable);
    if (plan->writable)
        add_option(command, "-w", plan->writable);
    if (SANITIZED || plan->sees_itself) // the shim becomes the process itself
        add_option(command, "-r", SANITIZED ? "/proc" : "/proc/self");
    add(command, "--");
}

void bwrap_command_make(BwrapCommand *command, const Jail *jail, const JailPlan *plan,
                        char *const *arguments) {
    command->count = 0;
    if (jail->route == JAIL_BWRAP)
        add_bwrap(command, jail, plan);
    add_shim(command, jail, plan);
    for (int i = 0; arguments[i]; i++)
        add(command, arguments[i]);
}

void bwrap_command_nursery(BwrapCommand *command, const Jail *jail, char *const *arguments) {
    command->count = 0;
    for (int i = 0; arguments[i]; i++)
        add(command, arguments[i]);
    for (int i = 0; i < SYSTEM_PATHS; i++)
        if (system_paths[i].kind == JAIL_DRAW && access(system_paths[i].path, F_OK) == 0)
            add(command, system_paths[i].path);
    add(command, jail->stage);
}
