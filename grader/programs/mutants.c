// mutants [--lab NN]... [--seeds N] [--only TEXT] [-j N] [--list]: does each rubric notice every small change
// of its solution? Makes them all (proof/mutations.h), grades each like a submission, over the seeds 1 to N
// (default 1) until a check fails, and prints those that pass and a table (Markdown, for grader/README.md).
// Exit status 1 when a change passes that equal.json does not call equal in effect, or when it is wrong about
// one; 3 when something could not be graded.
#include "base/places.h"
#include "base/temporary.h"
#include "proof/lab_mutants.h"
#include "scene/check.h"

#include <getopt.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { MAX_SEEDS = 100, MAX_LABS = 32, MAX_PROCESSES = 64 };

typedef struct Run {
    MutantSettings settings;
    bool list, unclean, broken;
    const char *labs[MAX_LABS];
    int lab_count;
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

static bool take_option(Run *run, int option) {
    switch (option) {
    case 's':
        run->settings.seeds = atoi(optarg);
        return run->settings.seeds >= 1 && run->settings.seeds <= MAX_SEEDS;
    case 'j':
        run->settings.processes = atoi(optarg);
        return run->settings.processes >= 1 && run->settings.processes <= MAX_PROCESSES;
    case 'o':
        run->settings.only = optarg;
        return true;
    case 'p':
        return run->list = true;
    case 'l':
        if (run->lab_count < MAX_LABS)
            run->labs[run->lab_count++] = optarg;
        return true;
    default:
        return false;
    }
}

static bool take_options(Run *run, int count, char **arguments) {
    static const struct option table[] = {{"lab", required_argument, NULL, 'l'},
                                          {"seeds", required_argument, NULL, 's'},
                                          {"only", required_argument, NULL, 'o'},
                                          {"list", no_argument, NULL, 'p'},
                                          {0}};
    for (int option; (option = getopt_long(count, arguments, "j:", table, NULL)) != -1;)
        if (!take_option(run, option))
            return false;
    return optind == count;
}

int main(int count, char **arguments) {
    static Run run = {.settings.seeds = 1};
    run.settings.processes = (int)sysconf(_SC_NPROCESSORS_ONLN);
    if (!take_options(&run, count, arguments)) {
        fprintf(stderr,
                "usage: build/mutants [--lab NN]... [--seeds 1..%d] [--only TEXT] [-j 1..%d] [--list]\n",
                MAX_SEEDS, MAX_PROCESSES);
        return 2;
    }
    signal(SIGPIPE, SIG_IGN);
    temporary_on_signals();
    if (!run.list)
        printf("| lab | made | compiled | killed | equal | survived | killed or equal, %% |\n"
               "|---|---|---|---|---|---|---|\n");
    fflush(stdout);
    if (run.lab_count == 0)
        places_list_labs(run_lab, &run);
    for (int i = 0; i < run.lab_count; i++)
        run_lab(run.labs[i], &run);
    if (run.broken)
        fprintf(stderr, "mutants: %s\n", check_message());
    return run.broken ? 3 : run.unclean;
}
