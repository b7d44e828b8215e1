// The way of one hand-in: grade it, compile it again, try each setting in all cameras, take the cheapest that
// errs little enough, and look whether its shadows come from a map.
#include "compete/entrant.h"

#include "base/printable.h"
#include "compete/second_count.h"
#include "compete/tally.h"
#include "grade/lab_verdict.h"
#include "grade/take_submission.h"
#include "intake/submission.h"
#include "scene/check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SECONDS = 300 }; // that its worker may use for all settings and cameras

// The first line of a text says enough.
static void give_reason(Standing *standing, const char *text) {
    char *shown = printable_name(text);
    snprintf(standing->reason, sizeof standing->reason, "%.*s", (int)strcspn(text, "\n"), shown);
    free(shown);
}

static bool passes(Standing *standing, Session *session, const char *path) {
    Report report = {0};
    if (!session_grade(session, path, &report))
        return false;
    const LabResult *lab = &report.labs[0];
    char text[STANDING_REASON] = "it does not pass: nothing of this lab was found";
    if (report.lab_count > 0 && lab->message[0])
        snprintf(text, sizeof text, "it does not pass: %.300s", lab->message);
    else if (report.lab_count > 0)
        snprintf(text, sizeof text, "it does not pass: %.4g of %.4g points", lab->score, lab->max_score);
    standing->ranked = report.lab_count > 0 && lab->status == LAB_PASSED;
    if (!standing->ranked)
        give_reason(standing, text);
    session_free(&report);
    return true;
}

static WorkerClient client_of(const Session *session) {
    return (WorkerClient){.trust = TRUST_NOBODY,
                          .jail = session->options.jail,
                          .context = session->options.context,
                          .quick_shaders = true,
                          .muted = session->options.hidden,
                          .seconds = SECONDS};
}

static void refuse(Standing *standing, const char *text) {
    standing->ranked = false;
    give_reason(standing, text);
}

static void take_tally(Standing *standing, const ArenaTally *tally, const char *setting) {
    standing->taps = tally->taps;
    standing->fragments = tally->fragments;
    standing->texels = tally->texels;
    standing->error = tally->error;
    snprintf(standing->setting, sizeof standing->setting, "%s", setting);
    standing_cost(standing);
}

// The cheapest setting that errs little enough; -1 with the reason where none does.
static int choose(Standing *standing, const Arena *arena, WorkerClient *client) {
    Standing tried = *standing;
    double least = INFINITY;
    int chosen = -1;
    for (int i = 0; i < arena->setting_count; i++) {
        ArenaTally tally;
        if (!tally_take(&tally, arena, i, client, COUNTED_READS)) {
            refuse(standing, check_message());
            return -1;
        }
        least = fmin(least, tally.error);
        take_tally(&tried, &tally, arena->settings[i].name);
        if (tally.error > arena->most_error || (chosen >= 0 && tried.cost >= standing->cost))
            continue;
        *standing = tried;
        chosen = i;
    }
    char text[STANDING_REASON];
    snprintf(text, sizeof text, "it errs too much: %.2f %% at least, %.2f %% count", 100 * least,
             100 * arena->most_error);
    if (chosen < 0)
        refuse(standing, text);
    return chosen;
}

// Whose reads all give 1, the farthest depth, finds no caster: what is dark then was not found in a map.
static void look_blind(Standing *standing, const Arena *arena, WorkerClient *client, int setting) {
    ArenaTally tally;
    if (!tally_take(&tally, arena, setting, client, COUNTED_BLIND))
        refuse(standing, check_message());
    else if (tally.dark > 0.1 * tally.true_dark)
        refuse(standing, "its shadows do not come from a map: they are there with an empty one, too");
}

// Ends the worker. False with a message when none could be started: then the hand-in is not to blame.
static bool end(WorkerClient *client) {
    const bool fault = client->fault;
    worker_client_stop(client);
    client->used_seconds = 0;
    return !fault || check_fail("no process that draws can be started");
}

// Counted by two workers: one compiles its shaders with the map and one without.
static bool compete(Standing *standing, const Arena *arena, const Rubric *rubric, WorkerClient *client) {
    const int chosen = choose(standing, arena, client);
    if (!end(client))
        return false;
    if (chosen >= 0)
        look_blind(standing, arena, client, chosen);
    if (!end(client))
        return false;
    if (standing->ranked)
        second_count(standing, arena, rubric, client, chosen);
    return true;
}

static bool take_and_compete(Standing *standing, const Arena *arena, Session *session, const char *folder) {
    static LabResult result;
    const Rubric *rubric = &session->examiners[0].rubric;
    WorkerClient client = client_of(session);
    result = (LabResult){0};
    grade_begin(&result, rubric);
    bool ok = files_make_temporary(client.folder) && take_submission(&result, &client, rubric, folder);
    if (ok && result.message[0])
        refuse(standing, result.message);
    else if (ok)
        ok = compete(standing, arena, rubric, &client);
    if (client.folder[0])
        files_remove(client.folder);
    result_destroy_lab(&result);
    return ok;
}

bool entrant_run(Standing *standing, const Arena *arena, Session *session, const char *path) {
    static Submission submission;
    char note[RESULT_TEXT];
    if (!passes(standing, session, path))
        return false;
    if (!standing->ranked)
        return true;
    bool ok = submission_open(&submission, session->options.jail, path) == EXTRACT_OK;
    const char *folder = ok ? submission_find_of(&submission, arena->lab, 1, note, sizeof note) : NULL;
    ok = folder && take_and_compete(standing, arena, session, folder);
    submission_close(&submission);
    return ok;
}
