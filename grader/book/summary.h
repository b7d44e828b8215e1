// What a class has in common: means of labs, tasks and checks, and the mistakes that many made. Whoever
// handed in nothing of a lab is no part of its means.
#pragma once

#include "book/book.h"

enum { SUMMARY_BINS = 11, SUMMARY_TEXT = 160 };

typedef struct SummaryLab {
    char name[SUMMARY_TEXT];
    int count, passed;            // of those who handed in
    double mean, median, maximum; // of the points that count
    int bins[SUMMARY_BINS];       // tenths of the points; the last: all of them
} SummaryLab;

// A check, or all checks of a task together.
typedef struct SummaryItem {
    int lab; // of the plan
    char task[16], name[SUMMARY_TEXT];
    int count, full; // who handed in; who has all but a trace of its points
    double share;    // mean, 0 to 1
} SummaryItem;

typedef struct SummaryMistake {
    int lab;
    char task[16], kind[256];
    int students;
    int last; // the row that was counted last
} SummaryMistake;

typedef struct Summary {
    SummaryLab labs[COURSE_MAX_LABS];
    SummaryItem *tasks, *checks; // lab by lab, in the order of the rubric
    int task_count, check_count;
    SummaryMistake *mistakes; // the commonest first
    int mistake_count;
} Summary;

// Counts all of the book; summary_destroy frees it.
void summary_make(Summary *summary, const Book *book);
void summary_destroy(Summary *summary); // accepts a zeroed summary

// A row's share of a task's measured points, 0 to 1; below 0 when there are none.
double summary_share(const Book *book, const BookRow *row, const SummaryItem *task);
