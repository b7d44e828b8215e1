// Writes the questions of a sheet, and puts one into a folder where nothing has been typed.
#include "predict/prediction_sheet.h"

#include "base/files.h"
#include "predict/prediction.h"
#include "predict/prediction_file.h"
#include "scene/check.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>

enum { WIDTH = 100 };

// Lines of comment, broken at spaces.
static void write_comment(FILE *out, const char *text) {
    while (*text) {
        int length = (int)strlen(text);
        for (int at = WIDTH - 2; length > WIDTH - 2 && at > 0; at--)
            if (text[at] == ' ')
                length = at;
        fprintf(out, "# %.*s\n", length, text);
        text += length + (text[length] == ' ');
    }
}

static void write_head(FILE *out, const char *id, long sheet) {
    char text[400];
    snprintf(
        text, sizeof text,
        "Predict first: work out each number by the handout's mathematics before you run lab %s, and type it "
        "in place of its ?. Only the number, with a point: 0.25. What is within 2 %% is right; what is "
        "counted "
        "must be exact.",
        id);
    write_comment(out, text);
    if (sheet) {
        fprintf(out, "sheet %ld\n", sheet);
        return;
    }
    snprintf(
        text, sizeof text,
        "`make predictions LAB=%s` puts numbers of your own into the questions; `make watch` does it, too.",
        id);
    write_comment(out, text);
    fputs("sheet ?\n", out);
}

static void write_question(FILE *out, const Rubric *rubric, int n, long sheet) {
    double given[PREDICTION_MAX_GIVEN];
    char question[PREDICTION_QUESTION], text[PREDICTION_QUESTION + 40];
    const Prediction *prediction = prediction_find(rubric->id, n);
    INVARIANT(prediction); // predictions_fit has counted
    prediction_draw(prediction, n, sheet, given);
    prediction_question(prediction, sheet ? given : NULL, question, sizeof question);
    const int points = rubric->prediction_points[n];
    snprintf(text, sizeof text, "%c, %d point%s: %s", 'a' + n, points, points == 1 ? "" : "s", question);
    fputc('\n', out);
    write_comment(out, text);
    fprintf(out, "%c ?\n", 'a' + n);
}

char *prediction_sheet_text(const Rubric *rubric, long sheet) {
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    INVARIANT(out);
    write_head(out, rubric->id, sheet);
    for (int n = 0; n < rubric->prediction_count; n++)
        write_question(out, rubric, n, sheet);
    fclose(out);
    INVARIANT(text);
    return text;
}

// Is there nothing in the file that a student would miss?
static bool is_untouched(const char *text, int count) {
    static PredictionFile file;
    prediction_file_read(&file, text, count);
    bool untouched = file.sheet == 0 && !file.message[0];
    for (int n = 0; n < count; n++)
        untouched = untouched && !file.entry[n].typed[0];
    return untouched;
}

static bool write_new(const Rubric *rubric, const char *path) {
    uint32_t drawn;
    if (getrandom(&drawn, sizeof drawn, 0) != sizeof drawn)
        return check_fail("no random number for %s", path);
    char *text = prediction_sheet_text(rubric, PREDICTION_FIRST_SHEET + drawn % PREDICTION_SHEETS);
    const bool ok = files_write_whole(path, text, true);
    free(text);
    return ok;
}

bool prediction_sheet_draw(const Rubric *rubric, const char *folder, bool *drawn) {
    char path[FILES_PATH];
    *drawn = false;
    files_join(path, folder, PREDICTION_FILE);
    if (files_exists(path)) {
        char *old = files_read(path, PREDICTION_MAX_FILE);
        const bool untouched = old && is_untouched(old, rubric->prediction_count);
        free(old);
        if (!untouched)
            return old != NULL;
    }
    *drawn = write_new(rubric, path);
    return *drawn;
}
