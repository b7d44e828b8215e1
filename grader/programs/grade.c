// The grader: see options.h for its command line and README.md for what it does.
#include "scene/check.h"
#include "class/class.h"
#include "jail/jail.h"
#include "jail/jail_choose.h"
#include "class/grade_options.h"
#include "grade/progress.h"
#include "exam/exam_file.h"
#include "report/evidence_files.h"
#include "base/temporary.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static bool add_labs(Session *session, const Options *options) {
    bool ok = options->lab_count > 0 || session_add(session, NULL);
    for (int i = 0; ok && i < options->lab_count; i++)
        ok = session_add(session, options->labs[i]);
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

static int grade_submission(Options *options) {
    static Session session;
    static Jail jail;
    Report report = {0};
    temporary_on_signals();
    bool ok = jail_choose(&jail, options->route, options->trusted, "grade", &options->grade.jail);
    session.options = options->grade;
    session.options.evidence = options->output || options->format == REPORT_HTML;
    int status = EXIT_COULD_NOT;
    if (ok && add_labs(&session, options) && session_grade(&session, options->submission, &report) &&
        write_evidence(&report, options->output) && report_print(&report, options->format, stdout))
        status = all_passed(&report) ? EXIT_ALL_PASSED : EXIT_NOT_ALL;
    else
        fprintf(stderr, "grade: could not grade: %s\n", check_message());
    if (options->record && status != EXIT_COULD_NOT)
        record(&report);
    session_free(&report);
    session_close(&session);
    jail_destroy(&jail);
    return status;
}

int main(int count, char **arguments) {
    static Options options;
    if (!options_parse(&options, count, arguments)) {
        fprintf(stderr, "grade: %s\n%s", check_message(), options_usage);
        return EXIT_USAGE;
    }
    signal(SIGPIPE, SIG_IGN);
    if (!options.seeded && !exam_file_draw_seed(&options.grade.seed)) {
        fprintf(stderr, "grade: %s\n", check_message());
        return EXIT_COULD_NOT;
    }
    int status = options.class_folder ? class_run(&options) : grade_submission(&options);
    free(options.only);
    return status;
}
