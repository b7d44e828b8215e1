// The way of a class run: read the folder, fix the settings, grade what has no record yet by several
// processes, and then write the tables from the records alone.
#include "class/class.h"

#include "scene/check.h"
#include "scene/count.h"
#include "class/run_log.h"
#include "exam/handed_out.h"
#include "jail/self_test.h"
#include "jail/jail.h"
#include "jail/jail_choose.h"
#include "class/run_settings.h"
#include "base/pool.h"
#include "class/submission_record.h"
#include "base/progress_bar.h"
#include "class/roster.h"
#include "class/regrade.h"
#include "class/rounds.h"
#include "class/run_folder.h"

#include <malloc.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { TRIES = 2 };

typedef struct Class {
    const ClassSettings *settings;
    ClassTables make_tables;
    void *context; // of make_tables
    Jail jail;
    Roster roster;
    RunSettings plan;
    Origin origin;
    Rounds rounds;
    Session session; // of a process of the pool, once it has graded something
    bool ready;
    ProgressBar bar;
    int not_graded; // of this run
} Class;

// A submission that could not be drawn is to blame only if the jail still holds whoever is in it.
static bool is_to_blame(const Class *class, const Report *report) {
    bool broken = false;
    for (int i = 0; i < report->lab_count; i++)
        broken = broken || report->labs[i].message[0];
    check_clear();
    return !broken || self_test(&class->jail);
}

// Each submission needs as many pictures as the one before: their memory is not given back between them.
static void keep_memory(void) {
    enum { MIB = 1 << 20 };
    mallopt(M_MMAP_THRESHOLD, 32 * MIB);
    mallopt(M_TRIM_THRESHOLD, 256 * MIB);
}

// By the exam of its round. Where exams are recorded (handed_out.h) there is only that of the class's seed.
static bool grade_in_round(Class *class, const RosterEntry *entry, const char *path, Report *report) {
    Session *session = &class->session;
    Meeting meeting;
    if (!session->attempts)
        return session_grade(session, path, report);
    if (!rounds_meet(&class->rounds, entry, &meeting))
        return false;
    session->meets = meeting.alone ? NULL : &meeting.seed;
    const bool ok = session_grade(session, path, report) && rounds_same(&class->rounds, entry, &meeting);
    session->meets = NULL;
    return ok;
}

static bool grade_entry(Class *class, const RosterEntry *entry, Report *report) {
    char path[FILES_PATH];
    bool made;
    const HandInFacts facts = hand_in_facts(&class->roster, entry); // as it was before it was graded
    if (!class->ready)
        keep_memory();
    if (!class->ready)
        class->ready = run_settings_session(&class->plan, &class->jail, &class->session);
    bool ok = class->ready && roster_fetch(&class->roster, entry, path, &made) &&
              grade_in_round(class, entry, path, report) && is_to_blame(class, report) &&
              submission_record_write(class->settings->output, entry, report,
                                      origin_json(&class->origin, &class->plan, facts.hash), &facts);
    if (class->ready && made)
        files_remove(path);
    return ok;
}

static void work(Outcome *outcome, void *context) {
    Class *class = context;
    Report report = {0};
    outcome->done = grade_entry(class, &class->roster.entries[outcome->job], &report);
    outcome->score = result_score(&report);
    outcome->maximum = result_max_score(&report);
    snprintf(outcome->reason, sizeof outcome->reason, "%s", outcome->done ? "" : check_message());
    session_free(&report);
}

static void finished(const Outcome *outcome, void *context) {
    Class *class = context;
    const RosterEntry *entry = &class->roster.entries[outcome->job];
    char *reason = printable_name(outcome->reason), *line = NULL;
    int length;
    if (outcome->done) {
        length = asprintf(&line, "%s: %.2f of %.0f", entry->shown, outcome->score, outcome->maximum);
    } else {
        length = asprintf(&line, "%s: not graded: %.*s", entry->shown, POOL_REASON, reason);
        class->not_graded++;
        check_clear();
        if (!submission_record_write_failure(class->settings->output, entry, outcome->reason))
            fprintf(stderr, "grade: %s\n", check_message());
    }
    run_log(class->settings->output, "%s", length < 0 ? entry->shown : line);
    progress_bar_step(&class->bar, length < 0 ? entry->shown : line, !outcome->done);
    free(reason);
    if (length >= 0)
        free(line);
}

// Writes the numbers of the entries that are to be graded to `jobs`. False with a message.
static bool choose(const Class *class, int *jobs, int *count) {
    const ClassSettings *settings = class->settings;
    *count = 0;
    for (int i = 0; i < settings->only_count; i++) {
        jobs[*count] = roster_find(&class->roster, settings->only[i]);
        if (jobs[(*count)++] < 0)
            return false;
    }
    if (!settings->only)
        *count = regrade_choose(jobs, settings->output, &class->roster, &class->plan, &class->origin,
                                !settings->list);
    return true;
}

static bool make_folders(const char *output) {
    static const char *const folders[] = {"results/", "pages/", "rounds/"};
    char path[FILES_PATH];
    for (size_t i = 0; i < COUNT(folders); i++) {
        files_join(path, output, folders[i]);
        if (!files_make_folder(path))
            return false;
    }
    files_join(path, output, "..");
    files_sync_folder(path); // what is in OUT is synced with its files
    return true;
}

static int processor_count(void) {
    long count = sysconf(_SC_NPROCESSORS_ONLN);
    return count < 1 ? 1 : count > 256 ? 256 : (int)count;
}

static bool grade_all(Class *class) {
    const ClassSettings *settings = class->settings;
    size_t most = (size_t) class->roster.count + (size_t)settings->only_count;
    int *jobs = calloc(most, sizeof *jobs), count;
    INVARIANT(jobs);
    bool ok = choose(class, jobs, &count) && (handed_out_alone() || rounds_sort(&class->rounds, jobs, count));
    if (ok) {
        int processes = settings->jobs ? settings->jobs : processor_count();
        const Pool pool = {.processes = processes < count ? processes : count,
                           .tries = TRIES,
                           .seconds = class->plan.lab_count * (3 * class->plan.seconds + 300),
                           .context = class,
                           .work = work,
                           .finished = finished};
        int total = settings->only ? count : class->roster.count;
        progress_bar_begin(&class->bar, stdout, "class", total, total - count);
        ok = pool_run(&pool, jobs, count);
        progress_bar_end(&class->bar);
    }
    free(jobs);
    return ok;
}

// Is there a run in OUT, to go on with?
static bool has_begun(const ClassSettings *settings) {
    char path[FILES_PATH];
    if (settings->resume)
        files_join(path, settings->output, "class.json");
    return settings->resume && files_exists(path);
}

// All names, or with --resume those that it would grade.
static bool print_list(Class *class) {
    const Roster *roster = &class->roster;
    int *jobs = calloc((size_t)roster->count + 1, sizeof *jobs), count = roster->count;
    INVARIANT(jobs);
    for (int i = 0; i < count; i++)
        jobs[i] = i;
    const bool ok = !has_begun(class->settings) ||
                    (run_settings_open(&class->plan, class->settings) &&
                     origin_read(&class->origin, &class->plan) && choose(class, jobs, &count));
    for (int i = 0; ok && i < count; i++)
        puts(roster->entries[jobs[i]].file);
    free(jobs);
    return ok;
}

static void note_ignored(const Roster *roster) {
    for (int i = 0; i < roster->ignored_count; i++)
        fprintf(stderr, "grade: ignored: \"%s\" %s\n", roster->ignored[i].name, roster->ignored[i].why);
}

static bool grade_in_jail(Class *class) {
    const Jail *chosen;
    class->rounds = (Rounds){class->settings->output, &class->roster, class->plan.seed, NULL, 0};
    bool ok = jail_choose(&class->jail, class->settings->route, false, "grade", &chosen) && grade_all(class);
    rounds_destroy(&class->rounds);
    jail_destroy(&class->jail);
    return ok;
}

// The whole class: alone in OUT, with a workplace.
static bool grade_rest(Class *class) {
    const char *output = class->settings->output;
    bool ok = run_folder_create(output) && grade_in_jail(class);
    run_folder_destroy(output);
    return ok;
}

// Makes the tables. A run of the whole class has as many submissions without a grade as the tables have.
static bool gather(Class *class) {
    const ClassSettings *settings = class->settings;
    const int turn = run_log_enter(settings->output);
    Table table;
    int not_graded = 0;
    table_read(&table, settings->output, &class->roster, &class->plan, &class->origin);
    for (int i = 0; i < class->roster.count; i++)
        not_graded += !table_is_graded(&table, i);
    if (!settings->only)
        class->not_graded = not_graded;
    const bool ok = class->make_tables(&table, settings, class->context);
    table_free(&table);
    run_log_leave(turn);
    return ok;
}

static bool grade_class(Class *class) {
    const ClassSettings *settings = class->settings;
    if (!make_folders(settings->output) || !run_settings_open(&class->plan, settings))
        return false;
    if (!origin_read(&class->origin, &class->plan))
        return false;
    if (settings->only)
        return grade_in_jail(class) && gather(class);
    return (settings->gather || grade_rest(class)) && gather(class);
}

// Lets `make_tables` look at what there is, and at the records of earlier runs.
static bool look(Class *class) {
    const ClassSettings *settings = class->settings;
    Table table;
    if (!run_settings_open(&class->plan, settings) || !origin_read(&class->origin, &class->plan))
        return false;
    table_read(&table, settings->output, &class->roster, &class->plan, &class->origin);
    const bool ok = class->make_tables(&table, settings, class->context);
    table_free(&table);
    return ok;
}

static bool do_run(Class *class) {
    const ClassSettings *settings = class->settings;
    return settings->dry_run ? look(class) : settings->list ? print_list(class) : grade_class(class);
}

static void say_end(const Class *class) {
    const char *output = class->settings->output;
    if (!class->settings->only)
        printf("%d submissions, %d not graded: %s/grades.csv, %s/index.html\n", class->roster.count,
               class->not_graded, output, output);
    if (class->not_graded > 0)
        printf("--resume tries again what is not graded\n");
}

bool class_run(const ClassSettings *settings, ClassTables make_tables, void *context) {
    static Class class;
    class.settings = settings;
    class.make_tables = make_tables;
    class.context = context;
    class.plan.lock = -1;
    bool ok = roster_read(&class.roster, settings->folder, settings->output, settings->all_attempts) &&
              do_run(&class);
    if (!ok) {
        fprintf(stderr, "grade: %s\n", check_message());
    } else if (!settings->list && !settings->dry_run) {
        note_ignored(&class.roster);
        say_end(&class);
        ok = class.not_graded == 0;
    }
    run_settings_close(&class.plan);
    roster_destroy(&class.roster);
    return ok;
}
