// Workers are forked where our attacks fail in one that was, and else not.
#include "exam/nursery_client.h"
#include "jail/jail.h"
#include "jail/jail_choose.h"
#include "scene/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

static Jail jail;

static char *environment[] = {"LP_NUM_THREADS=0", "MESA_SHADER_CACHE_DISABLE=true", "LIBGL_ALWAYS_SOFTWARE=1",
                              "LC_ALL=C", NULL};

// The second worker comes from the nursery, if there is one.
static bool forks(void) {
    static Process process;
    JailPlan plan = {.kind = JAIL_DRAW, .limits = {.wall_seconds = 20, .memory_mib = 2048, .file_mib = 1}};
    char folder[FILES_PATH];
    assert_true(files_make_temporary(folder));
    plan.folder = folder;
    assert_false(nursery_start(&jail, CONTEXT_OSMESA, &plan, &process, environment));
    const bool forked = nursery_start(&jail, CONTEXT_OSMESA, &plan, &process, environment);
    process_stop(&process);
    files_remove(folder);
    assert_int_equal(nursery_stop(), forked);
    return forked;
}

// As above: there is no nursery where an attack gets through in one of its children.
static void test_nursery(void **unused) {
    int status;
    (void)unused;
    if (!jail_create(&jail, JAIL_NONE)) {
        printf("skipped: %s\n", check_message());
        skip();
    }
#if defined(__SANITIZE_ADDRESS__)
    const bool fits = false;
#else
    const bool fits = jail.route == JAIL_BWRAP;
#endif
    assert_int_equal(forks(), fits);
    const pid_t child = fork(); // another process, with a nursery of its own
    if (child == 0) {
        setenv("TMPDIR", jail.stage, 1);
        _exit(forks());
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
    jail_destroy(&jail);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_nursery)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
