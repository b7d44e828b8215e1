// Takes the numbers out of settings' names, and finds the number along which a method's curve runs.
#include "study/chart_label.h"

#include "pages/curve_colors.h"
#include "scene/check.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

// Skips " x 512" behind a 512.
static const char *skip_same(const char *at, double value) {
    char *end;
    if (strncmp(at, " x ", 3) != 0 || !isdigit((unsigned char)at[3]))
        return at;
    return strtod(at + 3, &end) == value ? end : at;
}

LabelNumbers label_numbers(const char *name) {
    LabelNumbers numbers = {.count = 0};
    const char *at = name;
    while (*at && numbers.count < LABEL_NUMBERS) {
        if (!isdigit((unsigned char)*at)) {
            at++;
            continue;
        }
        char *end;
        double value = strtod(at, &end);
        numbers.values[numbers.count++] = value;
        at = skip_same(end, value);
    }
    return numbers;
}

void label_write(const char *name, char text[LABEL_TEXT]) {
    LabelNumbers numbers = label_numbers(name);
    text[0] = '\0';
    for (int i = 0; i < numbers.count; i++)
        check_append(text, LABEL_TEXT, "%s%g", i ? "/" : "", numbers.values[i]);
    if (numbers.count == 0)
        check_append(text, LABEL_TEXT, "%.*s", (int)strcspn(name, " ,"), name);
}

bool label_same_family(const Finding *a, const Finding *b) {
    return a->method.submission == b->method.submission && strcmp(a->method.family, b->method.family) == 0;
}

// How many different values this number of the method's settings has.
static int count_values(const SceneFindings *findings, const Finding *of, int number) {
    int different = 0;
    for (int i = 0; i < findings->count; i++) {
        const Finding *finding = &findings->findings[i];
        if (!label_same_family(finding, of))
            continue;
        double value = label_numbers(finding->method.name).values[number];
        bool is_new = true;
        for (int j = 0; j < i; j++)
            is_new = is_new && (!label_same_family(&findings->findings[j], of) ||
                                label_numbers(findings->findings[j].method.name).values[number] != value);
        different += is_new;
    }
    return different;
}

static int main_number(const SceneFindings *findings, const Finding *of, int count) {
    int best = 0;
    for (int n = 1; n < count; n++)
        if (count_values(findings, of, n) >= count_values(findings, of, best))
            best = n;
    return best;
}

static bool differ_in_one(const LabelNumbers *a, const LabelNumbers *b, int number) {
    bool same = a->count == b->count && a->values[number] > b->values[number];
    for (int n = 0; n < a->count; n++)
        same = same && (n == number || a->values[n] == b->values[n]);
    return same;
}

int label_before(const SceneFindings *findings, int i) {
    const Finding *of = &findings->findings[i];
    LabelNumbers mine = label_numbers(of->method.name);
    int number = main_number(findings, of, mine.count), best = -1;
    double largest = 0;
    for (int j = 0; j < findings->count && mine.count > 0; j++) {
        LabelNumbers other = label_numbers(findings->findings[j].method.name);
        if (findings->findings[j].drawn && label_same_family(&findings->findings[j], of) &&
            differ_in_one(&mine, &other, number) && (best < 0 || other.values[number] > largest)) {
            best = j;
            largest = other.values[number];
        }
    }
    return best;
}

int label_family(const SceneFindings *findings, const char *family, bool submission) {
    int number = 0;
    for (int i = 0; i < findings->count; i++) {
        const Finding *finding = &findings->findings[i];
        if (finding->method.submission == submission && strcmp(finding->method.family, family) == 0)
            return number;
        bool is_new = true;
        for (int j = 0; j < i; j++)
            is_new = is_new && !label_same_family(&findings->findings[j], finding);
        number += is_new;
    }
    return -1;
}

const char *label_color(const SceneFindings *findings, const Method *method) {
    return method->submission ? curve_color_of_submission
                              : curve_colors[label_family(findings, method->family, false) % CURVE_COLORS];
}
