#include "grade/address.h"

#include "scene/check.h"
#include "base/places.h"
#include "compile/given.h"
#include "compile/lab_folder.h"
#include "grade/address_report.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

// For the one frame: of processor time, and so many times as much on the clock, for a machine that is full.
static const double SECONDS = 10, PATIENCE = 3;

static bool is_there(void) {
    char worker[FILES_PATH];
    struct stat info;
    places_build_path(worker, "worker_address");
    return stat(worker, &info) == 0 && info.st_size > 0;
}

static bool copy_files(const char *folder, const char *from, const Rubric *rubric) {
    bool ok = true;
    for (int i = 0; ok && i < rubric->file_count; i++) {
        char path[FILES_PATH], copy[FILES_PATH];
        files_join(path, from, rubric->files[i]);
        files_join(copy, folder, rubric->files[i]);
        char *text = files_read(path, DERIVE_MAX_FILE);
        ok = text && files_write(copy, text);
        free(text);
    }
    return ok;
}

static bool draw_again(WorkerClient *again, const WorkerClient *student, const Rubric *rubric) {
    static char log[COMPILE_LOG];
    static Reply reply;
    Image image = {0};
    const bool drawn = copy_files(again->folder, student->folder, rubric) &&
                       given_place(again->folder, rubric->id, again->jail) &&
                       compiler_build_for_address(again->folder, again->jail, log) &&
                       worker_client_draw(again, &student->crash, &image, &reply) != DRAW_OK;
    image_destroy(&image);
    return drawn;
}

static void add_text(LabResult *result, const char *found) {
    char text[sizeof result->checks[0].hint], clean[sizeof text];
    snprintf(text, sizeof text, "Drawn again with AddressSanitizer: %s", found);
    result_clean(clean, sizeof clean, text);
    check_append(result->message, sizeof result->message, "\n%s", clean);
    for (int c = 0; c < result->check_count; c++) {
        CheckResult *check = &result->checks[c];
        if (check->has_cause && !check->hint[0] && strncmp(check->mistake, "it crashed", 10) == 0)
            memcpy(check->hint, clean, sizeof check->hint);
    }
}

void address_explain(LabResult *result, const WorkerClient *student, const Rubric *rubric) {
    static WorkerClient again;
    char found[800];
    if (!student->has_crash || !is_there())
        return;
    again = (WorkerClient){.trust = TRUST_NOBODY,
                           .jail = student->jail,
                           .context = student->context,
                           .quick_shaders = true,
                           .address = true,
                           .seconds = SECONDS,
                           .patience = PATIENCE};
    if (files_make_temporary(again.folder)) {
        if (draw_again(&again, student, rubric) &&
            address_report_read(found, sizeof found, again.process.text, rubric))
            add_text(result, found);
        worker_client_stop(&again);
        files_remove(again.folder);
    }
    check_clear(); // what could not be explained is no fault
}
