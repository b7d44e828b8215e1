// Who examines one lab: its rubric and its exam, kept from one submission to the next.
#pragma once

#include "exam/exam.h"

#include <pthread.h>
#include <stdbool.h>

struct LabResult;

typedef struct GradeOptions {
    ContextKind context;
    double seconds;  // that a submission may run, per lab
    double patience; // see worker_client.h
    uint64_t seed;
    const Jail *jail; // NULL: their author grades them, outside
    bool hidden;      // who handed it in must not get the variants: see grade/hidden.h
    bool untimed;     // do not compare times with the solution's
    bool no_swap;     // do not exchange parts of the submission to find the fault
    void (*early)(const struct LabResult *result,
                  void *context); // gets the points before the causes are known
    void *early_context;
    bool evidence; // keep pictures of what failed in the result
} GradeOptions;

// An exam that a thread draws while something else is done.
typedef struct EarlyExam {
    bool running;
    pthread_t thread;
    GradeOptions options;
    Exam *exam;    // what it has drawn; NULL: nothing,
    char why[600]; // for this reason
} EarlyExam;

typedef struct LabExam {
    Rubric rubric;
    Painters painters;
    Exam *exam;    // NULL until it is first needed
    uint64_t seed; // that it was asked for
    bool control;  // the solution has come out of the jail as it must: see grade/control.h
    EarlyExam early;
} LabExam;

// Reads the rubric of the lab "03". False with a message.
bool lab_exam_open(LabExam *examiner, const char *id);

// The exam of the options' seed; drawn the first time, or read where there are no solutions. A hidden seed
// that gives too few variants stands for another one, made from it. Ours until one of another seed is asked
// for, or until lab_exam_forget or lab_exam_close. NULL with a message.
Exam *lab_exam_exam(LabExam *examiner, const GradeOptions *options);

// Begins to draw that exam beside what the caller does next; lab_exam_exam takes it, and nothing else of this
// header may be called before, but what forgets it. Without it lab_exam_exam draws it. Does nothing where
// there is nothing to draw.
void lab_exam_begin(LabExam *examiner, const GradeOptions *options);

// Between submissions: keeps what was drawn of the exam within some 128 MiB beside its references. Pictures
// of mistakes that one submission needed are mostly those that the next one needs.
void lab_exam_trim(LabExam *examiner);

// Stops what draws the exam until a picture is wanted that it has not got: it holds some 200 MiB a lab.
void lab_exam_rest(LabExam *examiner);

// Frees the exam and stops what draws it, but keeps the rubric.
void lab_exam_forget(LabExam *examiner);
void lab_exam_close(LabExam *examiner); // accepts a zeroed examiner
