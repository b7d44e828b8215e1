// mutants: does each rubric notice every small change
// of its solution? Makes them all (proof/mutations.h), grades each like a submission, over the seeds 1 to N
// (default 1) until a check fails, and prints those that pass and a table (Markdown).
// Exit status 1 when a change passes that equal.json does not call equal in effect, or when it is wrong about
// one; 3 when something could not be graded.
#include "base/command_line.h"
#include "base/option_values.h"
#include "base/places.h"
#include "proof/lab_mutants.h"
#include "scene/check.h"
#include "base/limits.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { MAX_SEEDS = 100, MAX_PROCESSES = 64 };

typedef struct Run {
    MutantSettings settings;
    bool list, unclean, broken;
    LabList labs;
} Run;

static void run_lab(const char *id, void *context) {
    Run *run = context;
    bool clean = true;
    if (run->broken)
        return;
    run->broken =
        !(run->list ? lab_mutants_list(id, run->settings.only) : lab_mutants_run(id, &run->settings, &clean));
    run->unclean |= !clean;
}

static bool take_seeds(void *target, const char *text) {
    return option_whole(target, text, 1, MAX_SEEDS);
}

static bool take_processes(void *target, const char *text) {
    return option_whole(target, text, 1, MAX_PROCESSES);
}

#define AT(field) offsetof(Run, field)
static const Option options[] = {
    {"lab", 0, "NN", "only this lab; may be repeated", AT(labs), option_labs},
    {"seeds", 0, "N", "so many, from seed 1 on (default 1)", AT(settings.seeds), take_seeds},
    {"only", 0, "TEXT", "only changes with this text in their description", AT(settings.only), option_text},
    {NULL, 'j', "N", "processes (default: one a processor)", AT(settings.processes), take_processes},
    {"list", 0, NULL, "print the changes, and grade nothing", AT(list), option_flag},
    {0}};
#undef AT

static const CommandLine command_line = {
    .program = "mutants",
    .forms = "[options]",
    .about =
        "Does each rubric notice every small change of its solution? Prints those that pass, and a table.\n",
    .options = options,
    .ending = "exit status: 0; 1 a change passes that equal.json does not name; 2 usage; 3 could not grade\n",
};

int main(int count, char **arguments) {
    static Run run = {.settings.seeds = 1};
    run.settings.processes = (int)sysconf(_SC_NPROCESSORS_ONLN);
    ContextKind context = CONTEXT_ANY; // whoever draws settles it in the same way
    command_line_take(&command_line, &run, count, arguments);
    if (!run.list)
        command_line_settle_context(&command_line, &context);
    if (!run.list)
        printf("| lab | made | compiled | killed | equal | survived | killed or equal, %% |\n"
               "|---|---|---|---|---|---|---|\n");
    fflush(stdout);
    if (run.labs.count == 0)
        places_list_labs(run_lab, &run);
    for (int i = 0; i < run.labs.count; i++)
        run_lab(run.labs.ids[i], &run);
    if (run.broken)
        fprintf(stderr, "mutants: %s\n", check_message());
    return run.broken ? 3 : run.unclean;
}
