// Builds the hand-in's shaders with our lab.c in a folder of its own, counts once more, and compares.
#include "compete/second_count.h"

#include "compete/tally.h"
#include "compile/lab_folder.h"
#include "exam/handed_out.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool is_c(const char *name) {
    const char *end = strrchr(name, '.');
    return end && (strcmp(end, ".c") == 0 || strcmp(end, ".h") == 0);
}

static char *text_of(const Rubric *rubric, int file, const WorkerClient *student) {
    char path[FILES_PATH];
    files_join(path, student->folder, rubric->files[file]);
    return is_c(rubric->files[file]) ? lab_folder_source(rubric, file, (Solved){SOLVED_ALL, NULL})
                                     : files_read(path, DERIVE_MAX_FILE);
}

// Their shaders and our C, compiled in `folder`.
static bool build(const char *folder, const Rubric *rubric, const WorkerClient *student) {
    char *texts[RUBRIC_MAX_FILES] = {0};
    bool ok = true;
    for (int i = 0; i < rubric->file_count; i++)
        ok = (texts[i] = text_of(rubric, i, student)) && ok;
    ok = ok && lab_folder_mixed(folder, student->folder, rubric, texts, student->jail);
    for (int i = 0; i < rubric->file_count; i++)
        free(texts[i]);
    return ok;
}

static void compare(Standing *standing, const Arena *arena, const ArenaTally *tally) {
    Standing second = {.taps = tally->taps, .fragments = tally->fragments, .texels = tally->texels};
    standing_cost(&second);
    if (tally->error > arena->most_error)
        snprintf(standing->note, sizeof standing->note,
                 "its shaders need its own lab.c, which alone has counted: read it");
    else if (second.cost > standing->cost)
        snprintf(standing->note, sizeof standing->note,
                 "with our lab.c its shaders cost %.1f: read its own to see why it costs less", second.cost);
}

void second_count(Standing *standing, const Arena *arena, const Rubric *rubric, const WorkerClient *student,
                  int setting) {
    static WorkerClient client;
    ArenaTally tally = {.error = 1};
    if (handed_out_alone())
        return;
    client = (WorkerClient){.trust = TRUST_NOBODY,
                            .jail = student->jail,
                            .context = student->context,
                            .quick_shaders = true,
                            .muted = student->muted,
                            .seconds = student->seconds};
    if (!files_make_temporary(client.folder) || !build(client.folder, rubric, student) ||
        !tally_take(&tally, arena, setting, &client, COUNTED_READS))
        tally.error = 1; // whatever was drawn before it failed
    compare(standing, arena, &tally);
    worker_client_stop(&client);
    if (client.folder[0])
        files_remove(client.folder);
    check_clear(); // what could not be counted is noted
}
