#include "predict/prediction.h"

#include "base/hash.h"
#include "scene/check.h"
#include "scene/random.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

extern const Prediction *const predictions_tables[]; // made by build.mk

const Prediction *prediction_find(const char *lab, int n) {
    for (int t = 0; predictions_tables[t]; t++)
        for (const Prediction *at = predictions_tables[t]; at->lab; at++)
            if (strcmp(at->lab, lab) == 0 && n-- == 0)
                return at;
    return NULL;
}

void prediction_draw(const Prediction *prediction, int n, long sheet, double given[PREDICTION_MAX_GIVEN]) {
    uint64_t seed = hash_bytes(HASH_START, prediction->lab, strlen(prediction->lab));
    seed = hash_bytes(seed, &(int64_t){n}, sizeof(int64_t));
    Random random = {hash_bytes(seed, &(int64_t){sheet}, sizeof(int64_t))};
    for (int i = 0; i < PREDICTION_MAX_GIVEN; i++) {
        const PredictionGiven *at = &prediction->given[i];
        given[i] = at->name ? at->low + at->step * random_int(&random, 0, at->count - 1) : 0;
    }
}

static void add_given(const Prediction *prediction, const double *given, const char *name, int length,
                      char *text, size_t size) {
    int i = 0;
    while (i < PREDICTION_MAX_GIVEN && prediction->given[i].name &&
           ((int)strlen(prediction->given[i].name) != length ||
            strncmp(prediction->given[i].name, name, (size_t)length) != 0))
        i++;
    INVARIANT(i < PREDICTION_MAX_GIVEN && prediction->given[i].name); // a question names only what it gives
    if (given)
        check_append(text, size, "%.10g", given[i]);
    else
        check_append(text, size, "[%.*s]", length, name);
}

void prediction_question(const Prediction *prediction, const double *given, char *text, size_t size) {
    text[0] = '\0';
    for (const char *at = prediction->question; *at;) {
        const int plain = (int)strcspn(at, "{");
        check_append(text, size, "%.*s", plain, at);
        at += plain;
        if (!*at)
            break;
        const int length = (int)strcspn(++at, "}");
        add_given(prediction, given, at, length, text, size);
        at += length + (at[length] == '}');
    }
}

double prediction_answer(const char *lab, int n, const double given[PREDICTION_MAX_GIVEN]) {
    const Prediction *prediction = prediction_find(lab, n);
    INVARIANT(prediction);
    return prediction->answer(given);
}

double prediction_radians(double degrees) {
    return degrees * acos(-1) / 180;
}
