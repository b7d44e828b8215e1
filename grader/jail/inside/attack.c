// jail_probe draw|tools VISIBLE OUT SECRET SOLUTIONS GRADER_PID [sanitized]
//
// The self-test's attacks. Prints a line for each that gets through, and for each thing that must be possible
// and is not; then "probed". The last attack would end the probe, so it comes after that line.
#include "jail/inside/attacks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void run(const AttackTarget *target, const Attack *attacks) {
    for (int i = 0; attacks[i].name; i++)
        if (!(attacks[i].only_draw && target->tools) && !(attacks[i].not_sanitized && target->sanitized) &&
            attacks[i].run(target))
            printf("%s\n", attacks[i].name), fflush(stdout);
}

static void need(bool possible, const char *name) {
    if (!possible)
        printf("%s is not possible\n", name);
}

int main(int count, char **arguments) {
    if (count < 7)
        return 2;
    const AttackTarget target = {.tools = strcmp(arguments[1], "tools") == 0,
                                 .visible = arguments[2],
                                 .out = arguments[3],
                                 .secret = arguments[4],
                                 .solutions = arguments[5],
                                 .grader = atoi(arguments[6]),
                                 .sanitized = count > 7 && strcmp(arguments[7], "sanitized") == 0};
    need(attack_read(target.visible), "reading a file of the submission");
    if (target.tools)
        need(attack_write(target.out, "made"), "writing the compiler's output");
    run(&target, attacks_on_files);
    run(&target, attacks_on_kernel);
    run(&target, attacks_on_processes); // last: who is traced stops at a signal
    puts("probed");
    fflush(stdout);
    attack_by_other_architecture();
    return 0;
}
