// The jail by its parts: the self-test refuses what is weakened on purpose, no process is left behind,
// archives are opened or refused. What untrusted code may try in it stands in hostile.c.
#include "scene/check.h"
#include "scene/count.h"
#include "base/places.h"
#include "jail/extract.h"
#include "jail/jail.h"
#include "jail/jail_choose.h"
#include "jail/self_test.h"

#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

static Jail jail;

// Enters the route before each test; a machine need not have both.
static int enter(void **route) {
    check_clear();
    if (jail_create(&jail, (JailRoute)(size_t)*route))
        return 0;
    printf("skipped: %s\n", check_message());
    return *route == (void *)JAIL_NONE ? -1 : 0;
}

static int leave(void **route) {
    (void)route;
    jail_destroy(&jail);
    return 0;
}

#define NEEDS_ROUTE()                                                                                        \
    if (jail.route == JAIL_NONE)                                                                             \
    skip()

static void test_some_route_holds(void **route) {
    (void)route;
    assert_true(jail.route != JAIL_NONE);
}

static void refused(const char *words) {
    check_clear();
    assert_false(self_test(&jail));
    if (!strstr(check_message(), words))
        fail_msg("no \"%s\" in: %s", words, check_message());
    check_clear();
}

static void test_intact(void **route) {
    (void)route;
    NEEDS_ROUTE();
    assert_true(self_test(&jail));
}

// The self-test puts its secret into the temporary folder; here that is one which the jail shows.
static void test_shows_too_much(void **route) {
    (void)route;
    NEEDS_ROUTE();
    char *before = getenv("TMPDIR") ? strdup(getenv("TMPDIR")) : NULL;
    setenv("TMPDIR", jail.stage, 1);
    refused("the self-test got through where submissions run: reading a file that is not the submission's");
    if (before)
        setenv("TMPDIR", before, 1);
    else
        unsetenv("TMPDIR");
    free(before);
}

static void use_shim(const char *name) {
    char from[FILES_PATH], to[FILES_PATH], command[3 * FILES_PATH];
    places_build_path(from, name);
    jail_part(&jail, "jail_shim", to);
    snprintf(command, sizeof command, "cp '%s' '%s'", from, to);
    assert_int_equal(system(command), 0);
}

static void test_without_filter(void **route) {
    (void)route;
    NEEDS_ROUTE();
    use_shim("weak_filter");
    refused("the self-test got through where submissions run:");
}

static void test_without_limits(void **route) {
    (void)route;
    NEEDS_ROUTE();
    use_shim("weak_limit");
    refused("raising limits");
}

// With bubblewrap the namespace alone hides the files.
static void test_without_landlock(void **route) {
    NEEDS_ROUTE();
    use_shim("weak_files");
    if (*route == (void *)JAIL_LANDLOCK)
        refused("reading a file that is not the submission's");
    else
        assert_true(self_test(&jail));
}

static void test_without_shim(void **route) {
    (void)route;
    NEEDS_ROUTE();
    char shim[FILES_PATH];
    jail_part(&jail, "jail_shim", shim);
    assert_int_equal(unlink(shim), 0);
    refused("it does not start");
}

static void start_shell(Process *process, const char *script) {
    char *arguments[] = {"/bin/sh", "-c", (char *)script, NULL},
         *environment[] = {"PATH=/usr/bin:/bin", NULL};
    JailPlan plan = {.kind = JAIL_TOOLS, .limits = {.wall_seconds = 10}, .folder = jail.stage};
    assert_true(jail_start(&jail, &plan, process, arguments, environment));
}

static void assert_nobody_left(pid_t group) {
    assert_int_equal(kill(-group, 0), -1);
    assert_int_equal(errno, ESRCH);
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1);
    assert_int_equal(errno, ECHILD);
}

// For AddressSanitizer: /proc tells a process of itself, and of nothing else. The jail of a grader that is
// itself built with it shows all of /proc: that one grades nobody.
static void test_sees_itself(void **route) {
    (void)route;
#if defined(__SANITIZE_ADDRESS__)
    skip();
#endif
    NEEDS_ROUTE();
    static Process process;
    char script[400];
    snprintf(script, sizeof script,
             "read a </proc/self/statm && echo self; exec 2>&-; "
             "for f in /proc/1/cmdline /proc/1/status /proc/%ld/environ /proc/%ld/status /proc/version "
             "/proc/cpuinfo; "
             "do { read a <$f; } && echo got $f; done; echo end",
             (long)getpid(), (long)getppid());
    char *arguments[] = {"sh", "-c", script, NULL}, *environment[] = {"PATH=/usr/bin:/bin", NULL};
    const JailPlan plan = {
        .kind = JAIL_TOOLS, .limits = {.wall_seconds = 10}, .folder = jail.stage, .sees_itself = true};
    assert_true(jail_start(&jail, &plan, &process, arguments, environment));
    process_wait(&process);
    assert_string_equal(process.text, "self\nend\n");
    process_stop(&process);
}

static void test_leaves_nobody(void **route) {
    static Process process;
    (void)route;
    NEEDS_ROUTE();
    start_shell(&process, "(sleep 100 >&- 2>&- & sleep 100 >&- 2>&- &) & sleep 100 >&- 2>&- & echo gone");
    pid_t group = process.pid;
    process_wait(&process);
    assert_non_null(strstr(process.text, "gone"));
    process_stop(&process);
    assert_nobody_left(group);
}

// Also when it is killed while the jail is still being built around it.
static void test_killed_at_once(void **route) {
    static Process process;
    (void)route;
    NEEDS_ROUTE();
    for (int i = 0; i < 40; i++) {
        start_shell(&process, "sleep 100 & sleep 100");
        pid_t group = process.pid;
        usleep((useconds_t)(i * 200));
        process_stop(&process);
        assert_nobody_left(group);
    }
}

// A death by a signal is told as such, through bubblewrap too.
static void test_tells_signals(void **route) {
    static Process process;
    (void)route;
    NEEDS_ROUTE();
    start_shell(&process, "kill -SEGV $$");
    process_wait(&process);
    assert_true(WIFSIGNALED(process.status) && WTERMSIG(process.status) == SIGSEGV);
    process_stop(&process);
}

static char archives[FILES_PATH], opened[FILES_PATH];

static Extracted extract(const char *name) {
    char path[FILES_PATH];
    files_join(path, archives, name);
    files_remove(opened);
    assert_true(files_make_folder(opened));
    check_clear();
    return jail_extract(&jail, path, opened);
}

static void assert_text(const char *name, const char *text) {
    char path[FILES_PATH];
    files_join(path, opened, name);
    char *found = files_read(path, 1000);
    assert_non_null(found);
    assert_string_equal(found, text);
    free(found);
}

static void test_opens_archives(void **route) {
    static const char *const good[] = {"good.zip",    "stored.zip", "good.tar.gz", "good.tar.bz2",
                                       "good.tar.xz", "good.tar",   "twice.zip"};
    (void)route;
    NEEDS_ROUTE();
    for (unsigned i = 0; i < COUNT(good); i++) {
        if (extract(good[i]) != EXTRACT_OK)
            fail_msg("%s: %s", good[i], check_message());
        assert_text("03-shadow-map/lab.c", "int a;\n");
        assert_text("03-shadow-map/shadow.frag", "void main() {}\n");
        assert_text("notes \u00e9.txt", "");
    }
    assert_int_equal(extract("through-link.zip"), EXTRACT_OK); // the link is passed over: the folder is ours
    assert_text("a/shadow-lab-hostile.c", "int a;\n");
    assert_false(files_exists("/tmp/shadow-lab-hostile.c"));
}

static void test_refuses_archives(void **route) {
    static const struct {
        const char *name, *words;
    } bad[] = {
        {"up.zip", "a path that leads out of it"},
        {"up-inside.zip", "a path that leads out of it"},
        {"absolute.zip", "a path that leads out of it"},
        {"dot.zip", "no plain name"},
        {"control.zip", "no plain name"},
        {"file-and-folder.zip", "\"lab.c/lab.c\" cannot be made"},
        {"symlink.zip", "\"lab.c\" is a link or a device"},
        {"symlink.tar.gz", "\"lab.c\" is a link or a device"},
        {"hardlink.tar.gz", "\"lab.c\" is a link or a device"},
        {"fifo.tar.gz", "\"lab.c\" is a link or a device"},
        {"device.tar.gz", "\"lab.c\" is a link or a device"},
        {"large-file.zip", "more than 16 MiB in one file"},
        {"large-sum.zip", "64 MiB in all"},
        {"many.zip", "more than 4000 files"},
        {"text.zip", "it is no .zip, .tar, .7z or .rar archive"},
        {"empty.zip", ""},
        {"cut.zip", ""},
        {"flipped.zip", "CRC"},
        {"messages.zip", "\"the archive cannot be read: No space left on device.c\" is a link or a device"}};
    (void)route;
    NEEDS_ROUTE();
    for (unsigned i = 0; i < COUNT(bad); i++) {
        if (extract(bad[i].name) != EXTRACT_BAD_ARCHIVE)
            fail_msg("%s is opened, or a fault: %s", bad[i].name, check_message());
        if (!strstr(check_message(), bad[i].words) || strncmp(check_message(), "the archive", 11) != 0)
            fail_msg("%s: no \"%s\" in: %s", bad[i].name, bad[i].words, check_message());
    }
    assert_false(files_exists("/tmp/shadow-lab-hostile"));
    assert_int_equal(extract("missing.zip"), EXTRACT_FAULT);
    assert_non_null(strstr(check_message(), "the archive cannot be read: No such file"));
}

static int make_archives(void **unused) {
    char script[FILES_PATH], command[3 * FILES_PATH];
    (void)unused;
    places_path(script, "grader/tests/helpers/archives.py");
    if (!files_make_temporary(archives))
        return -1;
    files_join(opened, archives, "opened");
    snprintf(command, sizeof command, "python3 -W ignore '%s' '%s'", script, archives);
    return system(command);
}

static int remove_archives(void **unused) {
    (void)unused;
    files_remove(archives);
    return 0;
}

#define ON(test, route)                                                                                      \
    { #test " " #route, test, enter, leave, (void *)(route) }
#define ON_BOTH(test) ON(test, JAIL_BWRAP), ON(test, JAIL_LANDLOCK)

int main(void) {
    const struct CMUnitTest tests[] = {
        ON(test_some_route_holds, JAIL_NONE), ON_BOTH(test_intact),         ON_BOTH(test_shows_too_much),
        ON_BOTH(test_without_filter),         ON_BOTH(test_without_limits), ON_BOTH(test_without_landlock),
        ON_BOTH(test_without_shim),           ON_BOTH(test_sees_itself),    ON_BOTH(test_leaves_nobody),
        ON_BOTH(test_killed_at_once),         ON_BOTH(test_tells_signals),  ON_BOTH(test_opens_archives),
        ON_BOTH(test_refuses_archives)};
    return cmocka_run_group_tests(tests, make_archives, remove_archives);
}
