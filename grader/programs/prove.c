// prove: proves a rubric. Over N seeds it draws, for each lab, the
// solution, the skeleton, the lab solved up to each task, each catalogued mistake and each alternative,
// grades them like a submission and prints a table (Markdown, for grader/proof/PROOFS.md). Exit status 3 when
// something of ours cannot be drawn, else 1 when one of them is not graded as it should be: solution and
// alternatives 100 %, skeleton 0 on every check, no task takes points away, mistakes below the pass mark and
// named correctly. `N passed, N failed` counts rows.
#include "scene/check.h"
#include "compile/rubric_file.h"
#include "grade/grade_lab.h"
#include "diagnose/diagnose.h"
#include "base/command_line.h"
#include "base/option_values.h"
#include "base/places.h"
#include "score/score.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_SEEDS = 100 };

typedef enum Kind { KIND_SOLUTION, KIND_SKELETON, KIND_PARTIAL, KIND_MISTAKE, KIND_ALTERNATIVE } Kind;

typedef struct ProofRow {
    Kind kind;
    int number; // of the task or of the mistake in the rubric
    Solved solved;
    const Change *change;
    const struct ProofRow *before; // of a partial solution: the one with a task less
    double percent;                // of the last run
    double lowest, highest;        // percent
    int right, seeds;              // runs graded as they should be
    WorkerClient contender;        // a worker of its own, kept over the seeds
    char other[128];               // a diagnosis that was not the mistake's name, or a check that went wrong
} ProofRow;

typedef struct Proof {
    int seeds, passed, failed;
    ContextKind context;
    bool broken; // a fault of ours
} Proof;

static void note(ProofRow *row, const char *text) {
    if (!row->other[0])
        snprintf(row->other, sizeof row->other, "%.120s", text);
}

// Is the mistake named in a failed check, first of what it may be, and nothing else in any?
static bool named_right(const LabResult *result, ProofRow *row) {
    bool named = false;
    for (int c = 0; c < result->check_count; c++) {
        const CheckResult *check = &result->checks[c];
        if (check->passed)
            continue;
        if (strncmp(check->mistake, row->change->name, strlen(row->change->name)) != 0) {
            note(row, check->has_cause ? check->mistake : result->message);
            return false;
        }
        named = true;
    }
    return named;
}

static bool all_zero(const LabResult *result, ProofRow *row) {
    for (int c = 0; c < result->check_count; c++)
        if (result->checks[c].share > 0) {
            note(row, result->checks[c].check->name);
            return false;
        }
    return true;
}

static bool all_full(const LabResult *result, ProofRow *row) {
    for (int c = 0; c < result->check_count; c++)
        if (result->checks[c].share < 1) {
            note(row, result->checks[c].check->name);
            return false;
        }
    if (result->message[0] || result->warnings[0])
        note(row, result->message[0] ? result->message : result->warnings);
    return !result->message[0] && !result->warnings[0];
}

static bool judge(const LabResult *result, ProofRow *row, const Rubric *rubric) {
    switch (row->kind) {
    case KIND_SKELETON:
        return all_zero(result, row);
    case KIND_PARTIAL:
        return row->percent >= row->before->percent - 1e-9;
    case KIND_MISTAKE:
        return named_right(result, row) && result->score < rubric->pass_mark / 100 * result->max_score &&
               result->status != LAB_PASSED;
    default:
        return all_full(result, row);
    }
}

static const Image *ours(const ProofRow *row, Exam *exam, int c, int n) {
    const Variant *variant = &exam->variants[c][n];
    if (row->kind == KIND_SKELETON)
        return &variant->skeleton;
    bool mistake = row->kind == KIND_MISTAKE;
    const Image *image =
        mistake ? exam_mistake(exam, row->number, c, n) : exam_partial(exam, row->number, c, n);
    const LatePicture *late =
        mistake ? &exam->mistakes[row->number][c][n] : &exam->partials[row->number][c][n];
    return image && late->drawn ? image : NULL;
}

static FrameFacts our_facts(const ProofRow *row, const Exam *exam, int c, int n) {
    return row->kind == KIND_SKELETON  ? (FrameFacts){0}
           : row->kind == KIND_MISTAKE ? exam->mistakes[row->number][c][n].facts
                                       : exam->partials[row->number][c][n].facts;
}

// Skeletons, partial solutions and mistakes are drawn for the diagnosis, too. Those frames are taken as the
// row's. False when one of them was not drawn: then the row's own worker has to say why.
static bool share_frames(LabResult *result, const ProofRow *row, Exam *exam) {
    if (row->kind != KIND_SKELETON && row->kind != KIND_PARTIAL && row->kind != KIND_MISTAKE)
        return false;
    for (int c = 0; c < result->check_count; c++)
        for (int n = 0; n < result->checks[c].check->variants; n++) {
            const Image *image = ours(row, exam, c, n);
            if (!image || !image_copy(&result->checks[c].yours[n], image))
                return false;
            result->checks[c].facts[n] = our_facts(row, exam, c, n);
        }
    return true;
}

// A worker that draws for one lab only and compiles its shaders well, and the one that draws for all of ours
// must show the same.
static bool draws_the_same(const LabResult *result, ProofRow *row, Exam *exam) {
    static LabResult shared;
    grade_begin(&shared, exam->rubric);
    bool same = true;
    if (share_frames(&shared, row, exam))
        for (int c = 0; same && c < shared.check_count; c++)
            for (int n = 0; same && n < shared.checks[c].check->variants; n++) {
                const Image *own = &result->checks[c].yours[n], *other = &shared.checks[c].yours[n];
                same = own->rgba && memcmp(own->rgba, other->rgba, image_bytes(own)) == 0;
            }
    result_destroy_lab(&shared);
    if (!same)
        note(row, "another picture in a worker of its own");
    return same;
}

static void draw_row(LabResult *result, ProofRow *row, const Painter *painter, Exam *exam) {
    row->contender.trust = TRUST_OURS;
    row->contender.context = exam->painters->context;
    memcpy(row->contender.folder, painter->folder, sizeof row->contender.folder);
    grade_begin(result, exam->rubric);
    grade_frames(result, exam, &row->contender, false);
}

// Most mistakes are named by their pictures alone, as in the student's kit. Where they draw nothing, only the
// part with the fault can tell.
static bool name_causes(LabResult *result, ProofRow *row, Exam *exam) {
    ProofRow unnamed = *row;
    return diagnose(result, exam, &row->contender, false) &&
           (row->kind != KIND_MISTAKE || named_right(result, &unnamed) ||
            diagnose(result, exam, &row->contender, true));
}

// Grades one of ours as if it were a submission: by a worker of its own, but for frames that are known from
// the second seed on.
static bool run_row(ProofRow *row, Exam *exam, Painters *painters) {
    static LabResult result;
    const Painter *painter = painters_get(painters, row->solved, row->change);
    if (!painter)
        return false;
    bool first = row->seeds == 0, same = true;
    grade_begin(&result, exam->rubric);
    if (!first && share_frames(&result, row, exam)) {
        grade_pictures(&result, exam);
    } else {
        result_destroy_lab(&result);
        draw_row(&result, row, painter, exam);
        same = draws_the_same(&result, row, exam);
    }
    memcpy(row->contender.folder, painter->folder, sizeof row->contender.folder);
    bool ok = name_causes(&result, row, exam);
    double percent = row->percent = 100 * result.score / result.max_score;
    if (first || percent < row->lowest)
        row->lowest = percent;
    if (first || percent > row->highest)
        row->highest = percent;
    row->seeds++;
    row->right += ok && same && judge(&result, row, exam->rubric);
    result_destroy_lab(&result);
    return ok;
}

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
            ok = run_row(&rows[i], exam, painters);
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
    {"context", 0, "C", "osmesa (default) or egl", offsetof(ProveCommand, context), option_context},
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
    Proof proof = {.seeds = command.seeds, .context = command.context};
    signal(SIGPIPE, SIG_IGN);
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
