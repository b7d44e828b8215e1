// Writes the student's files with some of our parts into a folder of its own, compiles and draws it in the
// jail, and tells only how many failed checks pass.
#include "diagnose/mixed_lab.h"

#include "base/files.h"
#include "compile/lab_folder.h"
#include "exam/handed_out.h"
#include "exam/frame_score.h"
#include "scene/check.h"

#include <stdlib.h>
#include <string.h>

static const double SECONDS = 2, PATIENCE = 5; // of processor time that one try may draw, and of the clock

bool mixed_lab_open(MixedLab *lab, const LabResult *result, Exam *exam, const WorkerClient *student,
                    const Solved *solved) {
    *lab = (MixedLab){.result = result, .exam = exam, .student = student};
    for (int i = 0; i < exam->rubric->file_count; i++) {
        MixedFile *file = &lab->files[i];
        char path[FILES_PATH];
        file->name = exam->rubric->files[i];
        files_join(path, student->folder, file->name);
        file->text = files_read(path, DERIVE_MAX_FILE);
        file->ours_text =
            solved ? lab_folder_source(exam->rubric, i, *solved) : handed_out_text(exam->rubric, i);
        if (!file->text || !file->ours_text)
            return false;
        functions_split(&file->theirs, file->text);
        functions_split(&file->ours, file->ours_text);
    }
    return true;
}

void mixed_lab_close(MixedLab *lab) {
    for (int i = 0; i < RUBRIC_MAX_FILES; i++) {
        free(lab->files[i].text);
        free(lab->files[i].ours_text);
    }
}

static char *mix(const MixedFile *file) {
    if (file->all_ours)
        return strdup(file->ours_text);
    return functions_compose(&file->theirs, &file->ours, &file->choice);
}

static bool build(const MixedLab *lab, const char *folder) {
    char *texts[RUBRIC_MAX_FILES] = {0};
    const Rubric *rubric = lab->exam->rubric;
    bool ok = true;
    for (int i = 0; i < rubric->file_count; i++)
        ok = (texts[i] = mix(&lab->files[i])) && ok;
    ok = ok && lab_folder_mixed(folder, lab->student->folder, rubric, texts, lab->student->jail);
    for (int i = 0; i < rubric->file_count; i++)
        free(texts[i]);
    return ok;
}

typedef struct Drawing {
    WorkerClient *worker;
    Image picture;
    bool alive, drew; // drew: any frame
} Drawing;

// Like the reference, or like one of ours that is also right.
static bool is_right(const MixedLab *lab, const Drawing *drawing, int c, int n, const FrameFacts *facts) {
    Exam *exam = lab->exam;
    const Variant *variant = &exam->variants[c][n];
    if (frame_score(&drawing->picture, facts, variant, &variant->reference).share >= SCORE_PASSED)
        return true;
    for (int a = 0; a < exam->rubric->also_count; a++) {
        const Image *ours = exam_also(exam, a, c, n);
        if (ours && frame_score(&drawing->picture, facts, variant, ours).share >= SCORE_PASSED)
            return true;
    }
    return false;
}

static bool passes(const MixedLab *lab, Drawing *drawing, int c, int n) {
    static Reply reply;
    if (!drawing->alive)
        return false;
    const DrawResult drawn =
        worker_client_draw(drawing->worker, &lab->exam->variants[c][n].request, &drawing->picture, &reply);
    drawing->alive = drawn == DRAW_OK || drawn == DRAW_FAILED;
    drawing->drew = drawing->drew || drawn == DRAW_OK;
    return drawn == DRAW_OK && is_right(lab, drawing, c, n, &reply.facts);
}

// The worst variants first: where they do not all pass, the others do not matter.
static int count_passing(const MixedLab *lab, Drawing *drawing) {
    int count = 0;
    for (int c = 0; c < lab->result->check_count; c++)
        count += lab->failed[c] && passes(lab, drawing, c, lab->result->checks[c].worst);
    for (int c = 0; c < lab->result->check_count && count == lab->failed_count; c++)
        for (int n = 0; lab->failed[c] && n < lab->exam->rubric->checks[c].variants; n++)
            if (n != lab->result->checks[c].worst && !passes(lab, drawing, c, n))
                return count - 1;
    return drawing->drew ? count : -1;
}

typedef struct Judging {
    MixedJudge *judge; // NULL: the checks that pass are counted
    void *context;
} Judging;

static bool judge_check(const MixedLab *lab, Drawing *drawing, int c, const Judging *judging) {
    static Reply reply;
    const Variant *variant = &lab->exam->variants[c][lab->result->checks[c].worst];
    const DrawResult drawn =
        worker_client_draw(drawing->worker, &variant->request, &drawing->picture, &reply);
    if (drawn != DRAW_OK && drawn != DRAW_FAILED) // what draws nothing, and says why, is black
        return false;
    judging->judge(judging->context, c, &drawing->picture, &reply.facts);
    return true;
}

static int judge_all(const MixedLab *lab, Drawing *drawing, const Judging *judging) {
    int count = 0;
    for (int c = 0; c < lab->result->check_count; c++) {
        if (lab->failed[c] && !judge_check(lab, drawing, c, judging))
            return -1;
        count += lab->failed[c];
    }
    return count;
}

// How many of the failed checks pass, or were drawn for the judge; -1: it cannot be compiled or drawn.
static int draw_with(const MixedLab *lab, const Judging *judging) {
    static WorkerClient worker;
    int count = -1;
    worker = (WorkerClient){.trust = TRUST_NOBODY,
                            .jail = lab->student->jail,
                            .context = lab->student->context,
                            .quick_shaders = true,
                            .seconds = SECONDS,
                            .patience = PATIENCE};
    if (!files_make_temporary(worker.folder))
        return -1;
    if (build(lab, worker.folder)) {
        Drawing drawing = {.worker = &worker, .alive = true};
        count = judging->judge ? judge_all(lab, &drawing, judging) : count_passing(lab, &drawing);
        image_destroy(&drawing.picture);
    }
    worker_client_stop(&worker);
    files_remove(worker.folder);
    check_clear();
    return count;
}

int mixed_lab_try(const MixedLab *lab) {
    return draw_with(lab, &(Judging){0});
}

bool mixed_lab_draw(const MixedLab *lab, MixedJudge *judge, void *context) {
    return draw_with(lab, &(Judging){judge, context}) == lab->failed_count;
}
