// The grader, of one submission or of a whole class. See grader/README.md.
#include "scene/check.h"
#include "book/compare.h"
#include "book/dry_run.h"
#include "book/gradebook.h"
#include "class/class.h"
#include "intake/archive.h"
#include "jail/jail.h"
#include "jail/jail_choose.h"
#include "grade/record_report.h"
#include "exam/exam_seeds.h"
#include "exam/handed_out.h"
#include "report/evidence_files.h"
#include "base/command_line.h"
#include "base/option_values.h"
#include "grade/session.h"
#include "report/report.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { EXIT_ALL_PASSED, EXIT_NOT_ALL, EXIT_COULD_NOT = 3 }; // and EXIT_USAGE

typedef struct GradeCommand {
    const char *submission, *output;
    const char *compare; // the older of two outputs of class runs; `submission` is the newer
    ReportFormat format;
    bool record, trusted;
    GradebookSettings book;
    ClassSettings class; // what a class and one submission have in common is here, too
} GradeCommand;

static bool take_seed(void *target, const char *text) {
    ClassSettings *class = target;
    return class->seeded = option_seed(&class->seed, text);
}

static bool take_timeout(void *target, const char *text) {
    ClassSettings *class = target;
    return class->timed = option_seconds(&class->seconds, text);
}

static bool take_format(void *target, const char *text) {
    return report_parse_format(target, text) ||
           check_fail("takes text, json, html, gradescope or check50, not \"%s\"", text);
}

static bool take_jobs(void *target, const char *text) {
    return option_whole(target, text, 1, 256);
}

static bool take_only(void *target, const char *name) {
    ClassSettings *class = target;
    class->only = realloc(class->only, sizeof *class->only * (size_t)(class->only_count + 1));
    INVARIANT(class->only);
    class->only[class->only_count++] = name;
    return true;
}

#define AT(field) offsetof(GradeCommand, field)
static const Option options[] = {
    {"lab", 0, "NN", "only this lab; may be repeated", AT(class.labs), option_labs},
    {"seed", 0, "N", "the variants of an earlier run (default: drawn at random)", AT(class), take_seed},
    {"context", 0, "C", "osmesa or egl (default: the first that is here); also SHADOW_LAB_CONTEXT",
     AT(class.context), option_context},
    {"format", 0, "F", "text (default), json, html, gradescope or check50", AT(format), take_format},
    {"output", 0, "DIR", "pictures of what failed: yours, reference, difference", AT(output), option_text},
    {"record", 0, NULL, "note the points in the progress (see progress.h)", AT(record), option_flag},
    {"timeout", 0, "S", "seconds that a submission may run per lab (default 20)", AT(class), take_timeout},
    {"jail", 0, "ROUTE", "bwrap or landlock: only this jail (default: the first that holds)", AT(class.route),
     jail_take_route},
    {"trusted", 0, NULL, "no jail: the submission is my own work", AT(trusted), option_flag},
    {"no-swap", 0, NULL, "do not look for the fault by putting our functions into the submission",
     AT(class.no_swap), option_flag},
    {.help = "of a whole class, one submission a folder or archive in DIR:"},
    {"class", 0, "DIR",
     "the submissions; --output is the folder for grades.csv, index.html, pages/ and\nresults/",
     AT(class.folder), option_text},
    {NULL, 'j', "N", "submissions at a time (default: one a processor)", AT(class.jobs), take_jobs},
    {"resume", 0, NULL, "go on with the run in OUT; what is graded stays", AT(class.resume), option_flag},
    {"all-attempts", 0, NULL, "grade each attempt; else the newest of each student", AT(class.all_attempts),
     option_flag},
    {"only", 0, "NAME", "grade only this one (again) and gather nothing; may be repeated", AT(class),
     take_only},
    {"gather", 0, NULL, "grade nothing; make grades.csv and index.html from the results", AT(class.gather),
     option_flag},
    {"roster", 0, "FILE", "a CSV of who takes the course; OUT keeps it, so that it is given once",
     AT(book.files.roster), option_text},
    {"overrides", 0, "FILE", "a CSV of points that people gave: student,lab,points,note; OUT keeps it",
     AT(book.files.overrides), option_text},
    {"due", 0, "FILE", "a JSON of due dates and what lateness costs; OUT keeps it", AT(book.files.late),
     option_text},
    {"export", 0, "SYSTEM",
     "canvas, moodle, gradescope or sqlite: OUT/export/, with a page a student named by id;\nmay be repeated",
     AT(book.exports), export_take},
    {"anonymous", 0, "FILE", "OUT/anonymous/: the class under pseudonyms, which FILE keeps: keep it secret",
     AT(book.anonymous), option_text},
    {"copies", 0, NULL, "OUT/copies.csv: pairs of hand-ins that have the same code", AT(book.copies),
     option_flag},
    {"no-points", 0, NULL, "pages that --export and --anonymous make have no points", AT(book.no_points),
     option_flag},
    {"compare", 0, "OLD",
     "who has other points in OUT NEW than in OLD, and by which checks; --output DIR: also\nDIR/changes.csv",
     AT(compare), option_text},
    {"dry-run", 0, NULL,
     "grade and write nothing: print what is found in each hand-in, and what would be graded;\n--output may "
     "be left out",
     AT(class.dry_run), option_flag},
    {"list", 0, NULL, "print the names of the results, one a line; with --resume: of what is not graded",
     AT(class.list), option_flag},
    {0}};
#undef AT

static bool is_folder(const char *path) {
    struct stat info;
    return (stat(path, &info) == 0 && S_ISDIR(info.st_mode)) || check_fail("%s is not a folder", path);
}

static bool can_be_opened(const char *path) {
    struct stat info;
    return (stat(path, &info) == 0 && S_ISREG(info.st_mode) && archive_is_name(path)) || is_folder(path);
}

static bool goes_with_tables(const GradeCommand *command) {
    const GradebookSettings *book = &command->book;
    return !book->no_points || gradebook_gives_away(book) ||
           check_fail("--no-points goes with --export or --anonymous");
}

static bool goes_with_dry_run(const GradeCommand *command) {
    const ClassSettings *class = &command->class;
    const GradebookSettings *book = &command->book;
    return !class->dry_run ||
           (!class->gather && !class->list && !gradebook_gives_away(book) && !book->copies) ||
           check_fail("--dry-run writes nothing: it does not go with --gather, --list, --export, --anonymous "
                      "or --copies");
}

static bool check_class(GradeCommand *command, const Operands *operands) {
    ClassSettings *class = &command->class;
    class->output = command->output;
    if (command->trusted)
        return check_fail("a class is graded in the jail only: --trusted does not go with --class");
    if (operands->count > 0)
        return check_fail("with --class there is no SUBMISSION: \"%s\"", operands->texts[0]);
    return (class->output || class->dry_run || (class->list && !class->resume) ||
            check_fail("--class needs --output OUT")) &&
           goes_with_dry_run(command) && is_folder(class->folder) && goes_with_tables(command) &&
           book_check_files(&command->book.files);
}

static bool check(void *settings, const Operands *operands) {
    GradeCommand *command = settings;
    const ClassSettings *class = &command->class;
    if (command->trusted && class->route != JAIL_NONE)
        return check_fail("--trusted and --jail exclude each other");
    if (class->folder && !command->compare)
        return check_class(command, operands);
    if (gradebook_is_asked_for(&command->book))
        return check_fail(
            "--roster, --overrides, --due, --export, --anonymous, --no-points and --copies go with --class");
    if (class->jobs || class->resume || class->gather || class->list || class->only || class->dry_run)
        return check_fail("-j, --resume, --only, --gather, --list and --dry-run go with --class");
    command->submission = operands->texts[0];
    if (command->compare)
        return operands->count == 1 && !class->folder
                   ? is_folder(command->compare) && is_folder(command->submission)
                   : check_fail("--compare takes two folders, OLD and NEW, and no --class");
    return operands->count == 1 ? can_be_opened(command->submission) : check_fail("give one SUBMISSION");
}

static const CommandLine command_line = {
    .program = "grade",
    .forms = "[options] SUBMISSION\n[options] --class DIR --output OUT\n--compare OLD NEW [--output DIR]",
    .about = "Grades a SUBMISSION: a folder or an archive in which the labs' folders lie at any depth.\n",
    .options = options,
    .ending = "exit status: 0 all passed (of a class: all graded; --dry-run: all can be graded), 1 not all "
              "passed (--dry-run:\n"
              "some need a look), 2 usage, 3 could not grade\n",
    .operand = "SUBMISSION",
    .most = 1,
    .check = check,
};

static bool add_labs(Session *session, const LabList *labs) {
    bool ok = labs->count > 0 || session_add(session, NULL);
    for (int i = 0; ok && i < labs->count; i++)
        ok = session_add(session, labs->ids[i]);
    return ok;
}

static bool write_evidence(const Report *report, const char *folder) {
    bool ok = true;
    for (int i = 0; ok && folder && i < report->lab_count; i++)
        ok = evidence_write(&report->labs[i], folder);
    return ok;
}

static bool all_passed(const Report *report) {
    bool passed = report->lab_count > 0;
    for (int i = 0; i < report->lab_count; i++)
        passed = passed && report->labs[i].status == LAB_PASSED;
    return passed;
}

// Pages and Gradescope's results go to students, who may not keep our pictures; where there are no solutions
// the variants are nobody's secret.
static bool is_for_others(ReportFormat format) {
    return (format == REPORT_HTML || format == REPORT_GRADESCOPE) && !handed_out_alone();
}

static int grade_submission(const GradeCommand *command) {
    static Session session;
    static Jail jail;
    Report report = {0};
    const ClassSettings *settings = &command->class;
    session.options = (GradeOptions){.context = settings->context,
                                     .seconds = settings->seconds,
                                     .seed = settings->seed,
                                     .no_swap = settings->no_swap,
                                     .hidden = is_for_others(command->format),
                                     .evidence = command->output || command->format == REPORT_HTML ||
                                                 command->format == REPORT_GRADESCOPE};
    int status = EXIT_COULD_NOT;
    bool ok = add_labs(&session, &settings->labs);
    session_begin(&session);
    ok = ok && jail_choose(&jail, settings->route, command->trusted, "grade", &session.options.jail);
    if (ok && session_grade(&session, command->submission, &report) &&
        write_evidence(&report, command->output) && report_print(&report, command->format, stdout))
        status = all_passed(&report) ? EXIT_ALL_PASSED : EXIT_NOT_ALL;
    else
        fprintf(stderr, "grade: could not grade: %s\n", check_message());
    if (command->record && status != EXIT_COULD_NOT)
        record_report(&report, &session, command->format == REPORT_TEXT);
    session_free(&report);
    session_close(&session);
    jail_destroy(&jail);
    return status;
}

static int compare(const GradeCommand *command) {
    if (compare_outputs(command->compare, command->submission, command->output, stdout))
        return EXIT_ALL_PASSED;
    fprintf(stderr, "grade: %s\n", check_message());
    return EXIT_COULD_NOT;
}

// What only reads records needs no context.
static bool draws(const GradeCommand *command) {
    return !command->compare && !command->class.gather && !command->class.list && !command->class.dry_run;
}

static int dry_run(const ClassSettings *class, const BookFiles *files) {
    DryRun run = {.files = *files};
    run.files.only_read = true;
    if (!class_run(class, dry_run_print, &run))
        return EXIT_COULD_NOT;
    return run.strange > 0 ? EXIT_NOT_ALL : EXIT_ALL_PASSED;
}

static int grade(GradeCommand *command) {
    ClassSettings *class = &command->class;
    if (command->compare)
        return compare(command);
    if (!class->seeded && !exam_seeds_draw(&class->seed)) {
        fprintf(stderr, "grade: %s\n", check_message());
        return EXIT_COULD_NOT;
    }
    if (!class->folder)
        return grade_submission(command);
    if (class->dry_run)
        return dry_run(class, &command->book.files);
    return class_run(class, gradebook_write, &command->book) ? EXIT_ALL_PASSED : EXIT_COULD_NOT;
}

int main(int count, char **arguments) {
    static GradeCommand command = {.class.seconds = 20};
    command_line_take(&command_line, &command, count, arguments);
    if (draws(&command))
        command_line_settle_context(&command_line, &command.class.context);
    const int status = grade(&command);
    free(command.class.only);
    return status;
}
