// The command line of the grader. See grader/README.md.
#include "check.h"
#include "grade_lab.h"
#include "home.h"
#include "progress.h"
#include "report.h"

#include <ctype.h>
#include <errno.h>
#include <getopt.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

enum { EXIT_ALL_PASSED, EXIT_NOT_ALL, EXIT_USAGE, EXIT_COULD_NOT };

static const char usage[] = "usage: build/grade [options] SUBMISSION\n"
                            "  SUBMISSION        a folder shaped like labs/, or the folder of one lab\n"
                            "  --lab NN          only this lab; may be repeated\n"
                            "  --seed N          the variants of an earlier run (default: drawn anew)\n"
                            "  --context C       osmesa (default) or egl; also SHADOW_LAB_CONTEXT\n"
                            "  --format F        text (default) or json\n"
                            "  --output DIR      pictures of what failed: yours, reference, difference\n"
                            "  --timeout S       seconds that a submission may run per lab (default 20)\n"
                            "  --record          note the points in the student's progress\n"
                            "exit status: 0 all passed, 1 not all passed, 2 usage, 3 could not grade\n";

typedef struct Options {
    GradeOptions grade;
    bool json, seeded, record;
    const char *labs[RESULT_MAX_LABS];
    int lab_count;
    const char *submission;
} Options;

static bool parse_seed(Options *options, const char *text) {
    char *end;
    errno = 0;
    options->grade.seed = strtoull(text, &end, 10);
    options->seeded = isdigit((unsigned char)text[0]) && *end == '\0' && errno == 0;
    return options->seeded || check_fail("--seed takes a whole number from 0 to 2^64 - 1, not \"%s\"", text);
}

static bool parse_timeout(Options *options, const char *text) {
    char *end;
    options->grade.seconds = strtod(text, &end);
    return (*end == '\0' && options->grade.seconds > 0 && options->grade.seconds <= 3600) ||
           check_fail("--timeout takes seconds above 0 and at most 3600, not \"%s\"", text);
}

static bool parse_lab(Options *options, const char *id) {
    char folder[FILES_PATH];
    if (strlen(id) != 2 || !home_find_lab(folder, id)) {
        check_clear();
        return check_fail("there is no lab \"%s\"; give two digits as in solutions/, for instance --lab 02",
                          id);
    }
    if (options->lab_count == RESULT_MAX_LABS)
        return check_fail("--lab was given more than %d times", RESULT_MAX_LABS);
    options->labs[options->lab_count++] = id;
    return true;
}

static bool parse_format(Options *options, const char *format) {
    options->json = strcmp(format, "json") == 0;
    return options->json || strcmp(format, "text") == 0 ||
           check_fail("--format takes text or json, not \"%s\"", format);
}

static bool parse_option(Options *options, int option, const char *value) {
    switch (option) {
    case 'l':
        return parse_lab(options, value);
    case 's':
        return parse_seed(options, value);
    case 'c':
        return context_parse(&options->grade.context, value);
    case 'f':
        return parse_format(options, value);
    case 'o':
        options->grade.output = value;
        return true;
    case 't':
        return parse_timeout(options, value);
    case 'r':
        options->record = true;
        return true;
    default:
        return check_fail("unknown option, or one without its value");
    }
}

static bool parse(Options *options, int count, char **arguments) {
    static const struct option table[] = {{"lab", required_argument, NULL, 'l'},
                                          {"seed", required_argument, NULL, 's'},
                                          {"context", required_argument, NULL, 'c'},
                                          {"format", required_argument, NULL, 'f'},
                                          {"output", required_argument, NULL, 'o'},
                                          {"timeout", required_argument, NULL, 't'},
                                          {"record", no_argument, NULL, 'r'},
                                          {"help", no_argument, NULL, 'h'},
                                          {0}};
    const char *context = getenv("SHADOW_LAB_CONTEXT");
    *options = (Options){.grade = {.seconds = 20}};
    if (context && !context_parse(&options->grade.context, context))
        return false;
    opterr = 0;
    for (int option; (option = getopt_long(count, arguments, "", table, NULL)) != -1;) {
        if (option == 'h') {
            fputs(usage, stdout);
            exit(EXIT_ALL_PASSED);
        }
        if (!parse_option(options, option, optarg))
            return false;
    }
    struct stat info;
    if (optind != count - 1)
        return check_fail("give one SUBMISSION");
    options->submission = arguments[optind];
    return (stat(options->submission, &info) == 0 && S_ISDIR(info.st_mode)) ||
           check_fail("%s is not a folder", options->submission);
}

// Is this the folder of one lab, by its name (03-...) or because it holds a lab.c?
static bool single_lab(const char *submission, char id[3]) {
    char path[FILES_PATH];
    files_join(path, submission, "lab.c");
    if (!files_exists(path))
        return false;
    INVARIANT(realpath(submission, path));
    const char *name = strrchr(path, '/') + 1;
    snprintf(id, 3, "%.2s", name);
    return true;
}

typedef struct Run {
    const Options *options;
    Report report;
    Rubric rubrics[RESULT_MAX_LABS]; // of the report's labs
    bool single;                     // the submission is one lab's folder
    char single_id[3];               // its number
    bool failed;                     // a fault of ours
} Run;

static bool find_submission(const Run *run, const char *id, char folder[FILES_PATH]) {
    if (run->single) {
        snprintf(folder, FILES_PATH, "%s", run->options->submission);
        return true;
    }
    return home_find_lab_in(folder, run->options->submission, id);
}

static void grade_one(const char *id, void *context) {
    Run *run = context;
    char ours[FILES_PATH], theirs[FILES_PATH];
    if (run->failed || run->report.lab_count == RESULT_MAX_LABS ||
        (run->single && strcmp(id, run->single_id) != 0))
        return;
    check_clear();
    Rubric *rubric = &run->rubrics[run->report.lab_count];
    if (!home_find_lab(ours, id) || !rubric_load(rubric, ours)) {
        run->failed = true;
        return;
    }
    LabResult *result = &run->report.labs[run->report.lab_count++];
    bool found = find_submission(run, id, theirs);
    if (!found)
        snprintf(theirs, sizeof theirs, "%s/%s", run->options->submission, strrchr(ours, '/') + 1);
    run->failed = !grade_lab(result, rubric, theirs, &run->options->grade, run->report.renderer);
}

static bool grade_all(Run *run) {
    if (run->options->lab_count == 0)
        return home_list_labs(grade_one, run) && !run->failed;
    for (int i = 0; i < run->options->lab_count; i++)
        grade_one(run->options->labs[i], run);
    return !run->failed;
}

// What does not compile is no step back: only labs that were drawn are noted.
static void record(const Report *report) {
    static Progress progress;
    for (int i = 0; i < report->lab_count; i++) {
        const LabResult *lab = &report->labs[i];
        check_clear();
        if (lab->status <= LAB_FAILED &&
            !progress_record(&progress, lab->id, lab->score, lab->max_score, result_done(lab)))
            fprintf(stderr, "grade: %s\n", check_message());
    }
    if (progress.note[0])
        fprintf(stderr, "grade: %s\n", progress.note);
}

static int finish(Run *run) {
    bool passed = run->report.lab_count > 0;
    for (int i = 0; i < run->report.lab_count; i++)
        passed = passed && run->report.labs[i].status == LAB_PASSED;
    if (run->options->record)
        record(&run->report);
    if (run->options->json && !report_json(&run->report, stdout))
        return EXIT_COULD_NOT;
    if (!run->options->json)
        report_text(&run->report, stdout, isatty(STDOUT_FILENO) && !getenv("NO_COLOR"));
    return passed ? EXIT_ALL_PASSED : EXIT_NOT_ALL;
}

int main(int count, char **arguments) {
    static Options options;
    if (!parse(&options, count, arguments)) {
        fprintf(stderr, "grade: %s\n%s", check_message(), usage);
        return EXIT_USAGE;
    }
    signal(SIGPIPE, SIG_IGN);
    static Run run;
    run = (Run){.options = &options};
    if (!options.seeded)
        INVARIANT(getrandom(&options.grade.seed, sizeof options.grade.seed, 0) == sizeof options.grade.seed);
    run.report = (Report){.seed = options.grade.seed,
                          .context = context_name(options.grade.context),
                          .labs = calloc(RESULT_MAX_LABS, sizeof *run.report.labs)};
    run.single = single_lab(options.submission, run.single_id);
    if (run.single && options.lab_count > 0)
        snprintf(run.single_id, sizeof run.single_id, "%s", options.labs[0]);
    double start = process_now();
    bool graded = run.report.labs && grade_all(&run);
    run.report.seconds = process_now() - start;
    int status = EXIT_COULD_NOT;
    if (graded)
        status = finish(&run);
    else
        fprintf(stderr, "grade: could not grade: %s\n", check_message());
    for (int i = 0; i < run.report.lab_count; i++) {
        result_destroy_lab(&run.report.labs[i]);
        rubric_destroy(&run.rubrics[i]);
    }
    free(run.report.labs);
    return status;
}
