// Exams in files: what our labs draw for some seeds, so that a copy of the project without solutions (the
// student's kit) grades all the same. They lie in ROOT/grader/recorded: seeds.json, and for each lab a folder
// like that of its solution, but with frames instead of the answers, and
// labs/ as it was handed out.
#pragma once

#include "exam/exam.h"

#include <stdbool.h>

// Writes the exam with all that exam_mistake and exam_partial can be asked for to folder/exam-SEED.json and
// folder/exam-SEED-CHECK.png. False with a message.
bool exam_file_save(Exam *exam, const char *folder);

// Reads the exam of the seed from the rubric's folder. False with a message.
bool exam_file_load(Exam *exam, const Rubric *rubric, uint64_t seed);

// Fills scene, request and reference of variant n of check c: one picture of a recorded exam, for who wants
// no more. `variant` must be zeroed or one whose pictures may be freed. False with a message.
bool exam_file_reference(const Rubric *rubric, uint64_t seed, int c, int n, Variant *variant);
