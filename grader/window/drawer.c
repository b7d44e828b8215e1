#include "window/drawer.h"

#include "scene/check.h"
#include "compile/lab_folder.h"
#include "base/places.h"
#include "diagnose/result.h"

#include <stdio.h>
#include <string.h>

static const double OURS_SECONDS = 60; // that a frame of ours may take
static const char truth_program[] = "truth_worker";

bool drawer_has_truth(void) {
    char path[FILES_PATH];
    places_build_path(path, truth_program);
    return files_exists(path);
}

static bool build(Drawer *drawer, const DrawerSetup *setup, const Drawer *earlier, char log[COMPILE_LOG]) {
    WorkerClient *client = &drawer->client;
    const char *lender = earlier->client.folder[0] ? earlier->client.folder : NULL;
    switch (setup->kind) {
    case FEED_TRUTH:
        client->program = truth_program;
        snprintf(client->folder, sizeof client->folder, "-");
        return true;
    case FEED_REFERENCE:
        return lab_folder_ours(client->folder, setup->rubric, (Solved){SOLVED_ALL, NULL}, NULL);
    default:
        drawer->removes = files_make_temporary(client->folder);
        return drawer->removes &&
               lab_folder_again(client->folder, lender, setup->rubric, setup->submission, NULL, log);
    }
}

bool drawer_start(Drawer *drawer, const DrawerSetup *setup, const Drawer *earlier, char log[COMPILE_LOG]) {
    bool mine = setup->kind == FEED_MINE;
    memset(drawer, 0, sizeof *drawer);
    log[0] = '\0';
    drawer->client.trust = mine ? TRUST_NOBODY : TRUST_OURS;
    drawer->client.context = setup->context;
    drawer->client.seconds = mine ? setup->seconds : OURS_SECONDS;
    drawer->client.each_turn = true;
    return build(drawer, setup, earlier, log) && worker_client_start(&drawer->client);
}

DrawResult drawer_describe(Drawer *drawer, Reply *reply) {
    const Request request = {.magic = PROTOCOL_MAGIC};
    worker_client_begin(&drawer->client);
    return worker_client_describe(&drawer->client, &request, &drawer->table, reply);
}

static void keep_known_knobs(const Description *known, Request *request) {
    int kept = 0;
    for (int i = 0; i < request->knob_count; i++)
        for (int k = 0; k < known->knob_count; k++)
            if (strcmp(known->knobs[k].name, request->knobs[i].name) == 0) {
                request->knobs[kept++] = request->knobs[i];
                break;
            }
    request->knob_count = kept;
}

// For who looks for a fault by printing. The limit on what a lab prints counts from frame to frame.
static void pass_on_output(Drawer *drawer) {
    static _Thread_local char clean[2 * PROCESS_OUTPUT];
    Process *process = &drawer->client.process;
    if (process->printed == 0)
        return;
    result_clean(clean, sizeof clean, process->text);
    printf("%s%s", clean, clean[strlen(clean) - 1] == '\n' ? "" : "\n");
    fflush(stdout);
    process_forget_output(process);
}

DrawResult drawer_draw(Drawer *drawer, const Request *request, Image *image, Reply *reply) {
    Request asked = *request;
    snprintf(asked.folder, sizeof asked.folder, "%.1000s", drawer->client.folder);
    if (!drawer->client.program)
        keep_known_knobs(&drawer->table, &asked);
    worker_client_begin(&drawer->client);
    DrawResult result = worker_client_draw(&drawer->client, &asked, image, reply);
    pass_on_output(drawer);
    return result;
}

void drawer_stop(Drawer *drawer) {
    worker_client_stop(&drawer->client);
    if (drawer->removes)
        files_remove(drawer->client.folder);
    drawer->client.folder[0] = '\0';
    drawer->removes = false;
}
