// Landlock has no functions in the C library and its header differs between systems; so its system calls and
// the few constants of the kernel's interface (Documentation/userspace-api/landlock.rst) stand here.
#include "jail/inside/shim_files.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

enum {
    EXECUTE = 1 << 0,
    WRITE_FILE = 1 << 1,
    READ_FILE = 1 << 2,
    READ_DIR = 1 << 3,
    REMOVE_FILE = 1 << 5,
    MAKE_REG = 1 << 8,
    FIRST_ABI_RIGHTS = (1 << 13) - 1,
    REFER = 1 << 13,     // ABI 2
    TRUNCATE = 1 << 14,  // ABI 3
    IOCTL_DEV = 1 << 15, // ABI 5
    NET = 3,             // ABI 4: bind and connect TCP
    SCOPE = 3,           // ABI 6: abstract sockets and signals
    ABI_VERSION = 1,     // flag of landlock_create_ruleset
    PATH_BENEATH = 1     // rule type
};

typedef struct Ruleset {
    uint64_t files, net, scope;
} Ruleset;

typedef struct __attribute__((packed)) Beneath {
    uint64_t rights;
    int32_t parent;
} Beneath;

static const uint64_t reading = EXECUTE | READ_FILE | READ_DIR;
static const uint64_t writing = WRITE_FILE | REMOVE_FILE | MAKE_REG | TRUNCATE;
static const uint64_t of_files = EXECUTE | READ_FILE | WRITE_FILE | TRUNCATE; // the others are of folders

static void allow(int ruleset, const char *path, uint64_t rights) {
    struct stat info;
    int parent = open(path, O_PATH | O_CLOEXEC);
    if (parent < 0 || fstat(parent, &info) != 0)
        shim_fail(path);
    Beneath rule = {.rights = S_ISDIR(info.st_mode) ? rights : rights & of_files, .parent = parent};
    if (syscall(SYS_landlock_add_rule, ruleset, PATH_BENEATH, &rule, 0) != 0)
        shim_fail(path);
    close(parent);
}

static Ruleset known_rights(long abi) {
    return (Ruleset){.files = FIRST_ABI_RIGHTS | (abi >= 2 ? REFER : 0) | (abi >= 3 ? TRUNCATE : 0) |
                              (abi >= 5 ? IOCTL_DEV : 0),
                     .net = abi >= 4 ? NET : 0,
                     .scope = abi >= 6 ? SCOPE : 0};
}

void shim_hide_files(const ShimPlan *plan) {
    long abi = syscall(SYS_landlock_create_ruleset, NULL, 0, ABI_VERSION);
    if (plan->needs_landlock && abi < 3) {
        errno = abi < 0 ? errno : ENOSYS;
        shim_fail("Landlock (Linux 6.2 or newer, enabled) is needed");
    }
    if (abi < 1)
        return;
    Ruleset known = known_rights(abi);
    size_t size = abi >= 6 ? sizeof known : abi >= 4 ? 2 * sizeof(uint64_t) : sizeof(uint64_t);
    int ruleset = (int)syscall(SYS_landlock_create_ruleset, &known, size, 0);
    if (ruleset < 0)
        shim_fail("Landlock");
    for (int i = 0; i < plan->readable_count; i++)
        allow(ruleset, plan->readable[i], reading);
    for (int i = 0; i < plan->writable_count; i++)
        allow(ruleset, plan->writable[i], (reading & ~(uint64_t)EXECUTE) | (writing & known.files));
    if (syscall(SYS_landlock_restrict_self, ruleset, 0) != 0)
        shim_fail("Landlock");
    close(ruleset);
}
