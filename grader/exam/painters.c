// Builds each version of our lab when it is first asked for, and draws it with the one worker of them all.
#include "exam/painters.h"

#include "scene/check.h"
#include "compile/lab_folder.h"
#include "compile/rubric_fit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool same_task(Solved a, Solved b) {
    return a.which == b.which && (a.task == b.task || (a.task && b.task && strcmp(a.task, b.task) == 0));
}

bool painters_start(Painters *painters) {
    if (painters->client.started)
        return true;
    painters->client = (WorkerClient){.folder = "-",
                                      .trust = TRUST_OURS,
                                      .context = painters->context,
                                      .quick_shaders = !painters->measures,
                                      .hardware = painters->measures && painters->context == CONTEXT_EGL};
    return worker_client_start(&painters->client);
}

const Painter *painters_get(Painters *painters, Solved solved, const Change *change) {
    for (int i = 0; i < painters->count; i++)
        if (same_task(painters->painters[i]->solved, solved) && painters->painters[i]->change == change)
            return painters->painters[i];
    INVARIANT(painters->count < EXAM_MAX_PAINTERS);
    Painter *painter = calloc(1, sizeof *painter);
    INVARIANT(painter);
    *painter = (Painter){.solved = solved, .change = change};
    if (!painters_start(painters) || !lab_folder_ours(painter->folder, painters->rubric, solved, change)) {
        free(painter);
        return NULL;
    }
    return painters->painters[painters->count++] = painter;
}

// Each file with such a part is one edit: from its whole text to its whole new text.
static bool fill_reset(Reset *reset, const Parts *parts) {
    static Functions ours;
    const int files[2] = {parts->list[reset->p].file, reset->q >= 0 ? parts->list[reset->q].file : -1};
    for (int i = 0; i < 2 && files[i] >= 0 && (i == 0 || files[1] != files[0]); i++) {
        Edit *edit = &reset->change.edits[reset->change.edit_count++];
        char *text = lab_folder_source(parts->rubric, files[i], (Solved){SOLVED_ALL, NULL});
        edit->file = parts->rubric->files[files[i]];
        edit->find = text;
        if (!text)
            return false;
        functions_split(&ours, text);
        edit->replace = parts_reset(parts, files[i], &ours, reset->p, reset->q);
        if (!edit->replace)
            return check_fail("there is no memory for %s", edit->file);
    }
    return true;
}

static void free_reset(Reset *reset) {
    for (int e = 0; e < reset->change.edit_count; e++) {
        free((char *)reset->change.edits[e].find);
        free((char *)reset->change.edits[e].replace);
    }
    free(reset);
}

const Painter *painters_reset(Painters *painters, const Parts *parts, int p, int q) {
    const Solved all = {SOLVED_ALL, NULL};
    for (int i = 0; i < painters->reset_count; i++)
        if (painters->resets[i]->p == p && painters->resets[i]->q == q)
            return painters_get(painters, all, &painters->resets[i]->change);
    if (painters->reset_count == EXAM_MAX_RESETS) {
        check_fail("there are more than %d versions of our lab", EXAM_MAX_RESETS);
        return NULL;
    }
    Reset *reset = calloc(1, sizeof *reset);
    INVARIANT(reset);
    reset->p = p;
    reset->q = q;
    reset->change.name = "a part as it was handed out";
    if (!fill_reset(reset, parts)) {
        free_reset(reset);
        return NULL;
    }
    painters->resets[painters->reset_count++] = reset;
    return painters_get(painters, all, &reset->change);
}

bool painters_draw(Painters *painters, const Painter *painter, const Request *request, Image *image,
                   Reply *reply) {
    static Request named;
    named = *request;
    int length = snprintf(named.folder, sizeof named.folder, "%s", painter->folder);
    INVARIANT(length < (int)sizeof named.folder);
    DrawResult result = worker_client_draw(&painters->client, &named, image, reply);
    return result == DRAW_OK || result == DRAW_FAILED ||
           check_fail("our own lab in %s could not draw: %s", painter->folder, reply->message);
}

bool painters_lost(const Painters *painters) {
    return painters->client.started && painters->client.process.state != PROCESS_RUNNING;
}

bool painters_fit(Painters *painters) {
    static Request request;
    static Reply reply;
    static Description lab;
    if (painters->fits)
        return true;
    if (!rubric_fit_sources(painters->rubric))
        return false;
    const Painter *solution = painters_get(painters, (Solved){SOLVED_ALL, NULL}, NULL);
    if (!solution)
        return false;
    request = (Request){.magic = PROTOCOL_MAGIC};
    INVARIANT(snprintf(request.folder, sizeof request.folder, "%s", solution->folder) <
              (int)sizeof request.folder);
    if (worker_client_describe(&painters->client, &request, &lab, &reply) != DRAW_OK)
        return check_fail("our own lab in %s does not say what it is: %s", solution->folder, reply.message);
    return painters->fits = rubric_fit_lab(painters->rubric, &lab);
}

void painters_destroy(Painters *painters) {
    worker_client_stop(&painters->client);
    for (int i = 0; i < painters->count; i++)
        free(painters->painters[i]);
    for (int i = 0; i < painters->reset_count; i++)
        free_reset(painters->resets[i]);
    painters->count = painters->reset_count = 0;
    painters->fits = false;
}
