#include "watch/predict_first.h"

#include "base/files.h"
#include "predict/prediction_sheet.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool draw(const LabBoard *board, int lab, bool *drawn) {
    char folder[FILES_PATH];
    const Rubric *rubric = &board->rubrics[lab];
    *drawn = false;
    lab_board_lab_folder(board, lab, folder);
    if (rubric->prediction_count == 0)
        return check_fail("lab %s has no predictions", rubric->id);
    return files_check_folder(folder) && predictions_fit(rubric) &&
           prediction_sheet_draw(rubric, folder, drawn);
}

void predict_first_draw(const LabBoard *board, int lab) {
    bool drawn;
    draw(board, lab, &drawn);
    check_clear();
}

// "labs/03-shadow-map/predictions.txt", from the folder of the labs on.
static void name_file(char name[FILES_PATH], const LabBoard *board) {
    char folder[FILES_PATH];
    lab_board_lab_folder(board, board->current, folder);
    const char *above = strrchr(board->folder, '/') ? strrchr(board->folder, '/') + 1 : board->folder;
    snprintf(name, FILES_PATH, "%.100s/%.100s/" PREDICTION_FILE, above, strrchr(folder, '/') + 1);
}

bool predict_first_print(const LabBoard *board) {
    char folder[FILES_PATH], path[FILES_PATH], name[FILES_PATH];
    bool drawn;
    lab_board_lab_folder(board, board->current, folder);
    if (!draw(board, board->current, &drawn)) {
        fprintf(stderr, "watch: %s\n", check_message());
        return false;
    }
    files_join(path, folder, PREDICTION_FILE);
    name_file(name, board);
    printf("%s %s\n\n", name,
           drawn ? "holds your questions: type each number in place of its ?"
                 : "has its questions already and stays as it is:");
    char *text = files_read(path, PREDICTION_MAX_FILE);
    if (text)
        fputs(text, stdout);
    free(text);
    return true;
}

void predict_first_show(Sheet *sheet, const LabBoard *board) {
    const Predictions *predictions = &board->verdict.predictions;
    char name[FILES_PATH];
    if (predictions->count == 0)
        return;
    name_file(name, board);
    const int most = predictions_max_points(predictions);
    if (predictions_open(predictions))
        sheet_wrapped(sheet, STYLE_NOTE, 2, "Predict first: %s (%d points)", name, most);
    else
        sheet_wrapped(sheet, STYLE_PLAIN, 2, "Predictions: %d of %d points", predictions_points(predictions),
                      most);
    if (predictions->message[0])
        sheet_text(sheet, STYLE_BAD, 2, predictions->message);
    for (int n = 0; n < predictions->count; n++) {
        char text[1100];
        snprintf(text, sizeof text, "%c: %s", 'a' + n, predictions->results[n].why);
        if (predictions->results[n].typed[0] && !predictions->results[n].right)
            sheet_text(sheet, STYLE_BAD, 2, text);
    }
}
