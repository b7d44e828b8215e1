// Short names of settings, for the points of a chart, and which of them belong to one curve.
#pragma once

#include "study/finding.h"

enum { LABEL_NUMBERS = 4, LABEL_TEXT = 32 };

// The numbers in a setting's name; "512 x 512" counts once.
typedef struct LabelNumbers {
    double values[LABEL_NUMBERS];
    int count;
} LabelNumbers;

// The first LABEL_NUMBERS of them, in their order.
LabelNumbers label_numbers(const char *name);

// "32 samples, 256 x 256" -> "32/256"; a name without numbers -> its first word.
void label_write(const char *name, char text[LABEL_TEXT]);

// The setting from which a curve leads to setting `i`: of the same method, with all numbers the same but one.
// That one is, of the method's numbers, the one with the most different values (the last of them); it is the
// next smaller one here. -1: none.
int label_before(const SceneFindings *findings, int i);

// Do two findings belong to one method of one author?
bool label_same_family(const Finding *a, const Finding *b);

// The place of a family in the list of the scene's families, in the order of their first setting.
int label_family(const SceneFindings *findings, const char *family, bool submission);

// The color of a setting's family, "#rrggbb".
const char *label_color(const SceneFindings *findings, const Method *method);
