#include "watch/predict_first.h"

#include "predict/prediction_sheet.h"
#include "scene/check.h"

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

bool predict_first_print(const LabBoard *board) {
    char folder[FILES_PATH];
    bool drawn;
    lab_board_lab_folder(board, board->current, folder);
    if (!draw(board, board->current, &drawn)) {
        fprintf(stderr, "watch: %s\n", check_message());
        return false;
    }
    printf("%s/" PREDICTION_FILE " %s\n", folder,
           drawn ? "holds your questions: type each number in place of its ?"
                 : "has its questions, or numbers, already; it stays as it is");
    return true;
}

void predict_first_show(Sheet *sheet, const LabBoard *board) {
    const Predictions *predictions = &board->verdict.predictions;
    char folder[FILES_PATH];
    if (predictions->count == 0)
        return;
    lab_board_lab_folder(board, board->current, folder);
    const char *above = strrchr(board->folder, '/') ? strrchr(board->folder, '/') + 1 : board->folder;
    const int most = predictions_max_points(predictions);
    if (predictions_open(predictions))
        sheet_wrapped(sheet, STYLE_NOTE, 2, "Predict first: %.100s/%.100s/" PREDICTION_FILE " (%d points)",
                      above, strrchr(folder, '/') + 1, most);
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
