// Grades submissions one after the other, with the same labs, seed and limits.
#pragma once

#include "grade/grade_lab.h"

#include <stdbool.h>

typedef struct Session {
    GradeOptions options;
    bool keep;     // exams from one submission to the next; else each is freed when its lab is done
    bool attempts; // each submission has a seed of its own: that of `meets`, or without it (NULL) one made
                   // from its files and `secret` (attempt.h)
    const uint64_t *meets;
    uint64_t secret;
    bool complete; // labs that were not handed in are in the report, too, also of a folder of one lab
    int lab_count;
    LabExam examiners[COURSE_MAX_LABS];
} Session;

// Adds the lab "03"; with NULL all labs. False with a message.
bool session_add(Session *session, const char *id);

// Begins to draw what the submission will be held against, where that is known already: one lab, one seed.
void session_begin(Session *session);

// Grades a folder or an archive (see submission.h). With one lab, a folder of which nothing tells of which
// lab it is is graded as that. The report must be freed by session_free. False with a message: a fault of
// ours, and no report.
bool session_grade(Session *session, const char *path, Report *report);

void session_free(Report *report);    // accepts a zeroed report
void session_close(Session *session); // accepts a zeroed session
