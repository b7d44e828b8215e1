// Both sides of the pipe: the child that grades and prepares in the time between, and the parent that asks
// and takes verdicts.
#include "watch/grading_process.h"

#include "scene/check.h"
#include "grade/grade_lab.h"
#include "base/places.h"
#include "watch/terminal.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

// What the process keeps: the examiner of the lab that was graded last.
typedef struct Kept {
    int lab; // -1: none
    LabExam examiner;
} Kept;

static void forget(Kept *kept) {
    lab_exam_close(&kept->examiner);
    *kept = (Kept){.lab = -1};
}

static bool keep(Kept *kept, int lab, const GradingOptions *options) {
    if (kept->lab == lab)
        return true;
    forget(kept);
    kept->lab = lab;
    return lab_exam_open(&kept->examiner, options->rubrics[lab].id);
}

static void copy_check(VerdictCheck *to, const CheckResult *from) {
    to->points = result_points(from);
    to->passed = from->passed;
    to->undone = from->undone;
    snprintf(to->task, sizeof to->task, "%s", from->cause_task ? from->cause_task : from->check->task);
    snprintf(to->mistake, sizeof to->mistake, "%s", from->mistake);
    snprintf(to->seen, sizeof to->seen, "%s", from->seen);
    snprintf(to->hint, sizeof to->hint, "%s", from->hint);
}

static void copy_result(LabVerdict *verdict, const LabResult *result) {
    verdict->status = result->status;
    verdict->done = result_done(result);
    verdict->score = result->score;
    verdict->max_score = result->max_score;
    memcpy(verdict->message, result->message, sizeof verdict->message);
    memcpy(verdict->warnings, result->warnings, sizeof verdict->warnings);
    memcpy(verdict->summary, result->summary, sizeof verdict->summary);
    verdict->predictions = result->predictions;
    verdict->check_count = result->check_count;
    for (int c = 0; c < result->check_count; c++)
        copy_check(&verdict->checks[c], &result->checks[c]);
}

static void send_verdict(const LabVerdict *verdict, int verdicts) {
    for (size_t sent = 0; sent < sizeof *verdict;) {
        ssize_t n = write(verdicts, (const char *)verdict + sent, sizeof *verdict - sent);
        if (n <= 0)
            break;
        sent += (size_t)n;
    }
}

typedef struct EarlyVerdict {
    int lab, verdicts;
    double start;
} EarlyVerdict;

// The points, as soon as they are known: the search for the fault takes a moment longer.
static void send_early(const LabResult *result, void *context) {
    static LabVerdict verdict;
    const EarlyVerdict *early = context;
    memset(&verdict, 0, sizeof verdict);
    copy_result(&verdict, result);
    for (int c = 0; c < verdict.check_count; c++)
        if (!verdict.checks[c].passed && !verdict.checks[c].mistake[0])
            strcpy(verdict.checks[c].mistake, "looking for the cause ...");
    verdict.lab = early->lab;
    verdict.more = true;
    verdict.seconds = process_now() - early->start;
    send_verdict(&verdict, early->verdicts);
}

static void find_folder(char folder[FILES_PATH], int lab, const GradingOptions *options) {
    const Rubric *rubric = &options->rubrics[lab];
    if (options->lab_folder)
        snprintf(folder, FILES_PATH, "%s", options->lab_folder);
    else if (!places_find_lab_in(folder, options->folder, rubric->id))
        snprintf(folder, FILES_PATH, "%s/%s", options->folder, strrchr(rubric->folder, '/') + 1);
    check_clear();
}

static void grade(LabVerdict *verdict, Kept *kept, int lab, const GradingOptions *options, int verdicts) {
    static LabResult result;
    char folder[FILES_PATH];
    const double start = process_now();
    EarlyVerdict early = {lab, verdicts, start};
    const GradeOptions how = {.context = options->context,
                              .seconds = options->seconds,
                              .seed = options->seed,
                              .untimed = true,
                              .early = send_early,
                              .early_context = &early};
    memset(verdict, 0, sizeof *verdict);
    check_clear();
    bool ready = keep(kept, lab, options);
    find_folder(folder, lab, options);
    verdict->fault = !ready || !grade_lab(&result, &kept->examiner, folder, &how);
    copy_result(verdict, &result);
    if (verdict->fault)
        snprintf(verdict->message, sizeof verdict->message, "%s", check_message());
    result_destroy_lab(&result);
    verdict->lab = lab;
    verdict->seconds = process_now() - start;
}

static bool asked(int requests) {
    return poll(&(struct pollfd){.fd = requests, .events = POLLIN}, 1, 0) != 0;
}

// While the student thinks: draws the pictures of the catalogued mistakes, which the next diagnosis needs.
static void warm_up(Kept *kept, int requests) {
    const Rubric *rubric = &kept->examiner.rubric;
    Exam *exam = kept->examiner.exam;
    for (int m = 0; exam && m < rubric->mistake_count; m++)
        for (int c = 0; c < rubric->check_count; c++)
            for (int n = 0; n < rubric->checks[c].variants; n++)
                if (asked(requests) || !exam_mistake(exam, m, c, n))
                    return;
}

static _Noreturn void serve(const GradingOptions *options, const char *folder, int requests, int verdicts) {
    static Kept kept = {.lab = -1};
    static LabVerdict verdict;
    int lab;
    terminal_forget();
    setenv("TMPDIR", folder, 1);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    while (read(requests, &lab, sizeof lab) == sizeof lab) {
        grade(&verdict, &kept, lab, options, verdicts);
        send_verdict(&verdict, verdicts);
        if (verdict.fault)
            break;
        warm_up(&kept, requests);
    }
    forget(&kept);
    _exit(0);
}

static bool start(GradingProcess *grading) {
    int requests[2], verdicts[2];
    signal(SIGPIPE, SIG_IGN); // it can have died when it is asked
    if (!files_make_temporary(grading->folder))
        return false;
    if (pipe2(requests, O_CLOEXEC) != 0)
        return check_fail("no pipe to a child process");
    if (pipe2(verdicts, O_CLOEXEC) != 0) {
        close(requests[0]), close(requests[1]);
        return check_fail("no pipe to a child process");
    }
    grading->pid = fork();
    if (grading->pid == 0) {
        close(requests[1]), close(verdicts[0]);
        serve(&grading->options, grading->folder, requests[0], verdicts[1]);
    }
    close(requests[0]), close(verdicts[1]);
    grading->requests = requests[1];
    grading->verdicts = verdicts[0];
    if (grading->pid > 0)
        return true;
    grading_process_stop(grading);
    return check_fail("no child process");
}

bool grading_process_ask(GradingProcess *grading, int lab) {
    INVARIANT(!grading->busy);
    if (grading->pid <= 0 && !start(grading))
        return false;
    if (write(grading->requests, &lab, sizeof lab) != sizeof lab) { // it died while it had nothing to do
        grading_process_stop(grading);
        if (!start(grading) || write(grading->requests, &lab, sizeof lab) != sizeof lab)
            return check_fail("the process that grades cannot be reached");
    }
    grading->verdict.lab = lab;
    grading->taken = 0;
    grading->busy = true;
    return true;
}

bool grading_process_take(GradingProcess *grading) {
    const int lab = grading->verdict.lab;
    ssize_t n = read(grading->verdicts, (char *)&grading->verdict + grading->taken,
                     sizeof grading->verdict - grading->taken);
    grading->taken += n > 0 ? (size_t)n : 0;
    if (n <= 0) {
        memset(&grading->verdict, 0, sizeof grading->verdict);
        grading->verdict.fault = true;
        grading->verdict.lab = lab;
        strcpy(grading->verdict.message, "the process that grades has ended; the next save starts it again");
    } else if (grading->taken < sizeof grading->verdict) {
        return false;
    }
    grading->taken = 0;
    grading->busy = grading->verdict.more;
    if (grading->verdict.fault)
        grading_process_stop(grading);
    return true;
}

void grading_process_stop(GradingProcess *grading) {
    if (grading->requests > 0)
        close(grading->requests), close(grading->verdicts);
    if (grading->pid > 0) {
        kill(grading->pid, SIGTERM);
        waitpid(grading->pid, NULL, 0);
    }
    if (grading->folder[0])
        files_remove(grading->folder);
    grading->folder[0] = '\0';
    grading->pid = grading->requests = grading->verdicts = 0;
    grading->busy = false;
}
