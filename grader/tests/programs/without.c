// without WHAT... -- COMMAND...: runs the command on a machine that lacks WHAT: landlock, userns. A filter
// answers its system calls as a kernel without them does. For tests of what the grader does there.
#include <errno.h>
#include <linux/sched.h>
#include <seccomp.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static int lack_landlock(scmp_filter_ctx filter) {
    return seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(landlock_create_ruleset), 0);
}

// As Ubuntu 24.04's AppArmor and kernel.unprivileged_userns_clone=0 do.
static int lack_userns(scmp_filter_ctx filter) {
    const struct scmp_arg_cmp asked = SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_NEWUSER, CLONE_NEWUSER);
    return seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1, asked) ||
           seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(unshare), 1, asked) ||
           seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0);
}

int main(int count, char **arguments) {
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    int i = 1;
    for (; i < count && strcmp(arguments[i], "--") != 0; i++) {
        int (*lack)(scmp_filter_ctx) = strcmp(arguments[i], "landlock") == 0 ? lack_landlock
                                       : strcmp(arguments[i], "userns") == 0 ? lack_userns
                                                                             : NULL;
        if (!filter || !lack || lack(filter) != 0)
            return 2;
    }
    if (i + 1 >= count || seccomp_load(filter) != 0)
        return 2;
    execvp(arguments[i + 1], arguments + i + 1);
    perror(arguments[i + 1]);
    return 127;
}
