// prove: proves a rubric. Over N seeds it draws, for each lab, the
// solution, the skeleton, the lab solved up to each task, each catalogued mistake and each alternative,
// grades them like a submission and prints a table (Markdown, for grader/proof/PROOFS.md). Exit status 3 when
// something of ours cannot be drawn, else 1 when one of them is not graded as it should be: solution and
// alternatives 100 %, skeleton 0 on every check, no task takes away what those before it earned, mistakes
// below the pass mark and named correctly. `N passed, N failed` counts rows.
#include "scene/check.h"
#include "compile/rubric_file.h"
#include "proof/proof_row.h"
#include "base/command_line.h"
#include "base/option_values.h"
#include "base/places.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_SEEDS = 100 };

typedef struct Proof {
    int seeds, passed, failed;
    ContextKind context;
    bool broken; // a fault of ours
} Proof;

// One row a task that a check is about, solved up to it.
static int list_partials(ProofRow *rows, int count, const Rubric *rubric) {
    for (int n = 1; n < EXAM_MAX_TASKS; n++) {
        const char *task = rubric_task(rubric, n);
        if (task)
            rows[count] = (ProofRow){.kind = KIND_PARTIAL,
                                     .solved = {SOLVED_UP_TO, task},
                                     .number = n,
                                     .before = &rows[count - 1]};
        count += task != NULL;
    }
    return count;
}

static int list_rows(ProofRow *rows, const Rubric *rubric) {
    int count = 0;
    rows[count++] = (ProofRow){.kind = KIND_SOLUTION};
    rows[count++] = (ProofRow){.kind = KIND_SKELETON, .solved = {SOLVED_NONE, NULL}};
    count = list_partials(rows, count, rubric);
    for (int i = 0; i < rubric->mistake_count; i++)
        rows[count++] = (ProofRow){.kind = KIND_MISTAKE, .change = &rubric->mistakes[i], .number = i};
    for (int i = 0; i < rubric->alternative_count; i++)
        rows[count++] = (ProofRow){.kind = KIND_ALTERNATIVE, .change = &rubric->alternatives[i]};
    return count;
}

static void print_rows(ProofRow *rows, int count, const Rubric *rubric, Proof *proof) {
    static const char *const kinds[] = {"solution", "skeleton", "up to", "mistake", "alternative"};
    for (int i = 0; i < count; i++) {
        const ProofRow *row = &rows[i];
        bool right = row->seeds == proof->seeds && row->right == row->seeds;
        proof->passed += right;
        proof->failed += !right;
        worker_client_stop(&rows[i].contender);
        printf("| %s | %s | %s | %.0f | %.0f | %s%s%s |\n", rubric->id, kinds[row->kind],
               row->change        ? row->change->name
               : row->solved.task ? row->solved.task
                                  : "",
               row->lowest, row->highest,
               right ? (row->kind == KIND_MISTAKE ? "named" : "as it should be") : "WRONG: ",
               right                       ? ""
               : row->other[0]             ? row->other
               : row->seeds < proof->seeds ? "not drawn"
                                           : "not below the pass mark",
               "");
    }
}

static bool prove_seeds(const Rubric *rubric, Proof *proof, ProofRow *rows, int count, Painters *painters) {
    Exam *exam = calloc(1, sizeof *exam);
    bool ok = exam != NULL;
    for (int seed = 1; ok && seed <= proof->seeds; seed++) {
        ok = exam_create(exam, rubric, painters, (uint64_t)seed);
        for (int i = 0; ok && i < count; i++)
            ok = proof_row_run(&rows[i], exam, painters);
        if (ok)
            exam_destroy(exam);
    }
    free(exam);
    return ok;
}

static void prove_lab(const char *id, void *context) {
    Proof *proof = context;
    static ProofRow rows[EXAM_MAX_PAINTERS];
    char folder[FILES_PATH];
    Rubric rubric = {0};
    if (proof->broken)
        return;
    bool ok = (places_find_lab(folder, id) || check_fail("there is no lab \"%s\"", id)) &&
              rubric_load(&rubric, folder);
    Painters painters = {.rubric = &rubric, .context = proof->context};
    if (ok) {
        int count = list_rows(rows, &rubric);
        ok = prove_seeds(&rubric, proof, rows, count, &painters);
        print_rows(rows, count, &rubric, proof);
    }
    painters_destroy(&painters);
    rubric_destroy(&rubric);
    proof->broken = !ok;
}

typedef struct ProveCommand {
    LabList labs;
    int seeds;
    ContextKind context;
} ProveCommand;

static bool take_seeds(void *target, const char *text) {
    return option_whole(target, text, 1, MAX_SEEDS);
}

static const Option options[] = {
    {"lab", 0, "NN", "only this lab; may be repeated", offsetof(ProveCommand, labs), option_labs},
    {"seeds", 0, "N", "so many, from seed 1 on (default 10)", offsetof(ProveCommand, seeds), take_seeds},
    {"context", 0, "C", "osmesa or egl (default: the first that is here)", offsetof(ProveCommand, context),
     option_context},
    {0}};

static const CommandLine command_line = {
    .program = "prove",
    .forms = "[options]",
    .about = "Proves the rubrics: grades what we know the grades of, and prints a table.\n",
    .options = options,
    .ending = "exit status: 0 all is graded as it should be, 1 not all, 2 usage\n",
};

int main(int count, char **arguments) {
    ProveCommand command = {.seeds = 10};
    command_line_take(&command_line, &command, count, arguments);
    command_line_settle_context(&command_line, &command.context);
    Proof proof = {.seeds = command.seeds, .context = command.context};
    printf(
        "| lab | kind | name | lowest %% | highest %% | verdict over %d seeds |\n|---|---|---|---|---|---|\n",
        proof.seeds);
    if (command.labs.count == 0)
        proof.broken = !places_list_labs(prove_lab, &proof) || proof.broken;
    for (int i = 0; i < command.labs.count; i++)
        prove_lab(command.labs.ids[i], &proof);
    if (proof.broken)
        fprintf(stderr, "prove: %s\n", check_message());
    printf("%d passed, %d failed\n", proof.passed, proof.failed + proof.broken);
    return proof.broken ? 3 : proof.failed > 0;
}
