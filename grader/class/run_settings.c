// Reads or writes OUT/class.json, refuses settings that differ from it, and holds the lock of the run.
#include "class/run_settings.h"

#include "scene/check.h"
#include "base/places.h"
#include "exam/handed_out.h"

#include <errno.h>
#include <fcntl.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

// On a busy machine a submission waits for others: what it may compute, not when it gets to it, must decide,
// so that scores do not depend on how many are graded at a time.
static const double PATIENCE = 3;

enum { LOCK_TRIES = 100, LOCK_PAUSE = 100 * 1000 }; // microseconds

static void add_lab(const char *id, void *context) {
    RunSettings *plan = context;
    if (plan->lab_count == COURSE_MAX_LABS)
        check_fail("there are more than %d labs", COURSE_MAX_LABS);
    else
        memcpy(plan->labs[plan->lab_count++], id, sizeof plan->labs[0]);
}

static bool from_settings(RunSettings *plan, const ClassSettings *settings) {
    *plan = (RunSettings){.seed = settings->seed,
                          .context = settings->context,
                          .seconds = settings->seconds,
                          .no_swap = settings->no_swap,
                          .lock = -1};
    for (int i = 0; i < settings->labs.count; i++)
        add_lab(settings->labs.ids[i], plan);
    return settings->labs.count > 0 || (places_list_labs(add_lab, plan) && !check_message()[0]);
}

static char *to_text(const RunSettings *plan) {
    json_t *labs = json_array();
    for (int i = 0; i < plan->lab_count; i++)
        json_array_append_new(labs, json_string(plan->labs[i]));
    json_t *root = json_pack("{s:i, s:o, s:s, s:f, s:b, s:o}", "version", 1, "seed",
                             json_sprintf("%llu", (unsigned long long)plan->seed), "context",
                             context_name(plan->context), "timeout", plan->seconds, "no_swap", plan->no_swap,
                             "labs", labs);
    char *text = json_dumps(root, JSON_INDENT(2) | JSON_REAL_PRECISION(10));
    json_decref(root);
    return text;
}

static bool from_file(RunSettings *plan, const char *path) {
    json_error_t error;
    const char *seed = NULL, *context = NULL;
    int no_swap = 0; // missing in a run of an earlier version
    json_t *labs = NULL, *lab, *root = json_load_file(path, 0, &error);
    *plan = (RunSettings){.lock = -1};
    size_t i;
    bool ok = root && json_unpack(root, "{s:s, s:s, s:F, s?b, s:o}", "seed", &seed, "context", &context,
                                  "timeout", &plan->seconds, "no_swap", &no_swap, "labs", &labs) == 0;
    plan->no_swap = no_swap;
    ok = ok && context_parse(&plan->context, context);
    if (ok)
        plan->seed = strtoull(seed, NULL, 10);
    json_array_foreach(labs, i, lab) {
        ok = ok && json_string_length(lab) == 2;
        if (ok)
            add_lab(json_string_value(lab), plan);
    }
    json_decref(root);
    return (ok && plan->lab_count > 0) || check_fail("%s is not what build/grade wrote there", path);
}

static bool same_labs(const RunSettings *plan, const ClassSettings *settings) {
    for (int i = 0; i < settings->labs.count; i++)
        if (i >= plan->lab_count || strcmp(plan->labs[i], settings->labs.ids[i]) != 0)
            return false;
    return settings->labs.count == 0 || settings->labs.count == plan->lab_count;
}

// May these settings go on with the plan that is there?
static bool agrees(const RunSettings *plan, const ClassSettings *settings) {
    if (!settings->resume && !settings->only && !settings->gather)
        return check_fail("%s holds a class run already: go on with it by --resume, or take another folder",
                          settings->output);
    if (settings->seeded && settings->seed != plan->seed)
        return check_fail("%s was begun with --seed %llu: for another seed take another folder",
                          settings->output, (unsigned long long)plan->seed);
    if (settings->timed && settings->seconds != plan->seconds)
        return check_fail("%s was begun with --timeout %g: for another one take another folder",
                          settings->output, plan->seconds);
    return same_labs(plan, settings) ||
           check_fail("%s was begun with other labs: take another folder for these", settings->output);
}

static bool take_lock(RunSettings *plan, const char *path, bool alone) {
    plan->lock = open(path, O_RDWR | O_CLOEXEC);
    if (plan->lock < 0)
        return check_fail("%s cannot be opened: %s", path, strerror(errno));
    for (int i = 0; i < LOCK_TRIES; i++) { // processes of a run that was just killed may still be going
        if (flock(plan->lock, (alone ? LOCK_EX : LOCK_SH) | LOCK_NB) == 0)
            return true;
        usleep(LOCK_PAUSE);
    }
    return check_fail("another run is at work in this folder (%s is locked)", path);
}

bool run_settings_open(RunSettings *plan, const ClassSettings *settings) {
    char path[FILES_PATH];
    *plan = (RunSettings){.lock = -1};
    if (!settings->output)
        return from_settings(plan, settings);
    files_join(path, settings->output, "class.json");
    if (!files_exists(path)) {
        if (settings->dry_run)
            return from_settings(plan, settings);
        if (settings->gather)
            return check_fail("%s holds no class run", settings->output);
        char *text = from_settings(plan, settings) ? to_text(plan) : NULL;
        bool made = text && files_write_whole(path, text, false);
        free(text);
        if (!made)
            return false;
    } else if (!from_file(plan, path) || !agrees(plan, settings)) {
        return false;
    }
    return from_file(plan, path) && (settings->gather || settings->list || settings->dry_run ||
                                     take_lock(plan, path, !settings->only));
}

void run_settings_close(RunSettings *plan) {
    if (plan->lock >= 0)
        close(plan->lock);
    plan->lock = -1;
}

bool run_settings_session(const RunSettings *plan, const Jail *jail, Session *session) {
    *session = (Session){.options = {.context = plan->context,
                                     .seconds = plan->seconds,
                                     .patience = PATIENCE,
                                     .seed = plan->seed,
                                     .jail = jail,
                                     .no_swap = plan->no_swap,
                                     .hidden = !handed_out_alone(),
                                     .evidence = true},
                         .attempts = !handed_out_alone(),
                         .secret = plan->seed,
                         .keep = true,
                         .complete = true};
    for (int i = 0; i < plan->lab_count; i++)
        if (!session_add(session, plan->labs[i]))
            return false;
    return true;
}
