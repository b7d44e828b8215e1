// Judges each number that stands in a submission, and tells what is wrong with the others.
#include "predict/predictions.h"

#include "base/blame.h"
#include "base/files.h"
#include "base/find_file.h"
#include "scene/check.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool predictions_fit(const Rubric *rubric) {
    const JsonPlace file = {.folder = rubric->folder, .file = "rubric.json"};
    int count = 0;
    while (prediction_find(rubric->id, count))
        count++;
    return count == rubric->prediction_count ||
           json_fields_fail(
               &file, "predictions",
               "has points for %d predictions, but the lab's predictions.c has %d; write a number "
               "for each",
               rubric->prediction_count, count);
}

void predictions_begin(Predictions *predictions, const Rubric *rubric) {
    *predictions = (Predictions){.count = rubric->prediction_count};
    for (int n = 0; n < rubric->prediction_count; n++)
        predictions->results[n].points = rubric->prediction_points[n];
}

static bool is_right(const Prediction *prediction, double answer, double value) {
    return fabs(value - answer) <= prediction->tolerance * fabs(answer) * (1 + 1e-9);
}

static void judge(PredictionResult *result, const Prediction *prediction, int n, long sheet,
                  const PredictionEntry *entry) {
    double given[PREDICTION_MAX_GIVEN];
    prediction_draw(prediction, n, sheet, given);
    prediction_question(prediction, given, result->question, sizeof result->question);
    memcpy(result->typed, entry->typed, sizeof result->typed);
    result->right = !entry->why[0] && is_right(prediction, prediction->answer(given), entry->value);
    if (entry->why[0])
        snprintf(result->why, sizeof result->why, "%s", entry->why);
    else if (!result->right && prediction->tolerance > 0)
        snprintf(result->why, sizeof result->why, "%s is not within %g %% of it. %s", entry->typed,
                 100 * prediction->tolerance, prediction->hint);
    else if (!result->right)
        snprintf(result->why, sizeof result->why, "%s is another number. %s", entry->typed, prediction->hint);
}

static void take(Predictions *predictions, const Rubric *rubric, const char *text) {
    static PredictionFile file;
    prediction_file_read(&file, text, predictions->count);
    memcpy(predictions->message, file.message, sizeof file.message);
    predictions->sheet = file.sheet;
    predictions->undrawn = !file.sheet && !file.message[0];
    if (predictions->undrawn)
        snprintf(
            predictions->message, sizeof predictions->message,
            "it has no sheet yet: `make predictions LAB=%s` writes numbers of your own into the questions",
            rubric->id);
    for (int n = 0; file.sheet && n < predictions->count; n++)
        judge(&predictions->results[n], prediction_find(rubric->id, n), n, file.sheet, &file.entry[n]);
}

bool predictions_take(Predictions *predictions, const Rubric *rubric, const char *folder) {
    char found[FIND_FILE_NAME];
    if (predictions->count == 0)
        return true;
    check_clear();
    errno = 0;
    if (!find_file(found, folder, PREDICTION_FILE)) {
        if (check_message()[0] && blame_is_ours(errno))
            return false;
        snprintf(predictions->message, sizeof predictions->message, "no prediction is handed in");
        check_clear();
        return true;
    }
    errno = 0;
    char *text = files_read_untrusted(folder, found, PREDICTION_MAX_FILE);
    if (!text && blame_is_ours(errno))
        return false;
    if (text)
        take(predictions, rubric, text);
    else
        snprintf(predictions->message, sizeof predictions->message, "%.*s", PREDICTION_MESSAGE - 1,
                 check_message());
    free(text);
    check_clear();
    return true;
}

void predictions_put_off(Predictions *predictions) {
    for (int n = 0; n < predictions->count; n++)
        predictions->results[n] = (PredictionResult){.points = predictions->results[n].points};
    predictions->sheet = 0;
    snprintf(predictions->message, sizeof predictions->message,
             "they are judged once the lab compiles and draws");
}

int predictions_points(const Predictions *predictions) {
    int points = 0;
    for (int n = 0; n < predictions->count; n++)
        points += predictions->results[n].right ? predictions->results[n].points : 0;
    return points;
}

int predictions_max_points(const Predictions *predictions) {
    int points = 0;
    for (int n = 0; n < predictions->count; n++)
        points += predictions->results[n].points;
    return points;
}

bool predictions_open(const Predictions *predictions) {
    for (int n = 0; n < predictions->count; n++)
        if (!predictions->results[n].typed[0])
            return true;
    return false;
}
