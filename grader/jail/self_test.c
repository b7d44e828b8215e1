#include "jail/self_test.h"

#include "scene/check.h"
#include "base/places.h"
#include "jail/jail.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__)
#define SANITIZED "sanitized" // its jail shows /proc and has no limit on addresses
#else
#define SANITIZED ""
#endif

// A folder "in" to be read, one "out" to be written to, and a secret beside them that only the jail keeps.
typedef struct Ground {
    char base[FILES_PATH], in[FILES_PATH], out[FILES_PATH], secret[FILES_PATH], visible[FILES_PATH];
} Ground;

static bool ground_create(Ground *ground) {
    if (!files_make_temporary(ground->base))
        return false;
    files_join(ground->in, ground->base, "in");
    files_join(ground->out, ground->base, "out");
    files_join(ground->secret, ground->base, "secret");
    files_join(ground->visible, ground->in, "visible");
    return files_make_folder(ground->in) && files_make_folder(ground->out) &&
           files_write(ground->secret, "secret") && files_write(ground->visible, "visible") &&
           ((chmod(ground->base, 0755) == 0 && chmod(ground->secret, 0666) == 0) ||
            check_fail("%s: %s", ground->base, strerror(errno)));
}

static bool start_probe(const Jail *jail, const Ground *ground, JailKind kind, StartInJail *start,
                        Process *process) {
    char probe[FILES_PATH], solutions[FILES_PATH], pid[16];
    jail_part(jail, "jail_probe", probe);
    places_path(solutions, "solutions");
    snprintf(pid, sizeof pid, "%ld", (long)getpid());
    char *arguments[] = {probe,
                         kind == JAIL_DRAW ? "draw" : "tools",
                         (char *)ground->visible,
                         (char *)ground->out,
                         (char *)ground->secret,
                         solutions,
                         pid,
                         SANITIZED,
                         NULL};
    char *environment[] = {"LC_ALL=C", NULL};
    JailPlan plan = {.kind = kind,
                     .limits = {.wall_seconds = 10, .cpu_seconds = 5, .memory_mib = 2048, .file_mib = 1},
                     .folder = ground->in,
                     .writable = kind == JAIL_TOOLS ? ground->out : NULL};
    return start(jail, &plan, process, arguments, environment);
}

// The probe prints a line for each attack that got through, and "probed" at its end.
static bool judge(const Process *process, JailKind kind) {
    const char *inside = kind == JAIL_DRAW ? "where submissions run" : "where the compiler runs";
    int first = (int)strcspn(process->text, "\n");
    if (strcmp(process->text, "probed\n") == 0)
        return true;
    if (strstr(process->text, "probed\n"))
        return check_fail("the self-test got through %s: %.*s", inside, first, process->text);
    return check_fail("it does not start: %.*s", first > 0 ? first : 50,
                      first > 0 ? process->text : "the self-test says nothing");
}

static bool try_kinds(const Jail *jail, int first, int count, StartInJail *start) {
    static Process processes[2];
    static const JailKind kinds[2] = {JAIL_DRAW, JAIL_TOOLS};
    Ground ground;
    memset(processes, 0, sizeof processes);
    bool ok = ground_create(&ground);
    for (int i = first; ok && i < first + count; i++)
        ok = start_probe(jail, &ground, kinds[i], start, &processes[i]);
    for (int i = first; ok && i < first + count; i++) {
        process_wait(&processes[i]);
        ok = judge(&processes[i], kinds[i]);
    }
    for (int i = 0; i < 2; i++)
        process_stop(&processes[i]);
    files_remove(ground.base);
    return ok;
}

bool self_test_of(const Jail *jail, JailKind kind, StartInJail *start) {
    return try_kinds(jail, kind == JAIL_TOOLS, 1, start);
}

bool self_test(const Jail *jail) {
    return try_kinds(jail, 0, 2, jail_start);
}
