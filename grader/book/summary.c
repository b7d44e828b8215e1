// Walks over all measured checks once for each table: labs, tasks, checks, mistakes.
#include "book/summary.h"

#include "base/statistics.h"
#include "scene/check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double trace = 0.95; // as CheckResult's `passed`

static void *grow(void *list, int count, size_t size) {
    const bool full = (count & (count - 1)) == 0; // room is always a power of two
    void *grown = full ? realloc(list, size * (size_t)(count ? 2 * count : 1)) : list;
    INVARIANT(grown);
    return grown;
}

static const json_t *checks_of(const Book *book, const BookRow *row, int n) {
    return row->marks[n].handed_in ? json_object_get(table_lab(book->table, row->entry, n), "checks") : NULL;
}

static void count_lab(SummaryLab *lab, const Book *book, int n) {
    double *points = calloc((size_t)book->count + 1, sizeof *points), sum = 0;
    INVARIANT(points);
    for (int r = 0; r < book->count; r++) {
        const BookMark *mark = &book->rows[r].marks[n];
        if (!mark->handed_in)
            continue;
        const json_t *result = table_lab(book->table, book->rows[r].entry, n);
        snprintf(lab->name, sizeof lab->name, "%s", table_text(result, "name"));
        lab->maximum = mark->maximum;
        lab->passed += strcmp(table_text(result, "status"), "passed") == 0;
        sum += points[lab->count++] = mark->points;
        const int bin = (int)((SUMMARY_BINS - 1) * mark->points / mark->maximum + 1e-9);
        lab->bins[bin < SUMMARY_BINS ? bin : SUMMARY_BINS - 1]++;
    }
    lab->mean = lab->count ? sum / lab->count : 0;
    lab->median = lab->count ? statistics_median(points, (size_t)lab->count) : 0;
    free(points);
}

static SummaryItem *find_item(SummaryItem **items, int *count, int lab, const char *task, const char *name) {
    for (int i = 0; i < *count; i++)
        if ((*items)[i].lab == lab && strcmp((*items)[i].task, task) == 0 &&
            strcmp((*items)[i].name, name) == 0)
            return &(*items)[i];
    *items = grow(*items, *count, sizeof **items);
    SummaryItem *item = &(*items)[(*count)++];
    *item = (SummaryItem){.lab = lab};
    snprintf(item->task, sizeof item->task, "%s", task);
    snprintf(item->name, sizeof item->name, "%s", name);
    return item;
}

static void find_items(Summary *summary, const Book *book, const BookRow *row, int n) {
    size_t i;
    const json_t *check;
    json_array_foreach(checks_of(book, row, n), i, check) {
        char name[SUMMARY_TEXT], task[16];
        snprintf(name, sizeof name, "%s", table_text(check, "name"));
        snprintf(task, sizeof task, "%s", table_text(check, "task"));
        find_item(&summary->checks, &summary->check_count, n, task, name);
        find_item(&summary->tasks, &summary->task_count, n, task, "");
    }
}

// The share of the checks of this task, with this name unless that is "".
static double share(const Book *book, const BookRow *row, const SummaryItem *item) {
    size_t i;
    const json_t *check;
    double points = 0, most = 0;
    json_array_foreach(checks_of(book, row, item->lab), i, check) {
        if (strncmp(table_text(check, "task"), item->task, sizeof item->task - 1) != 0 ||
            (item->name[0] && strncmp(table_text(check, "name"), item->name, SUMMARY_TEXT - 1) != 0))
            continue;
        points += table_number(check, "score");
        most += table_number(check, "max_score");
    }
    return most > 0 ? points / most : -1;
}

double summary_share(const Book *book, const BookRow *row, const SummaryItem *task) {
    return share(book, row, task);
}

static void count_item(SummaryItem *item, const Book *book) {
    double sum = 0;
    for (int r = 0; r < book->count; r++) {
        const double part = share(book, &book->rows[r], item);
        if (part < 0)
            continue;
        sum += part;
        item->count++;
        item->full += part >= trace;
    }
    item->share = item->count ? sum / item->count : 0;
}

static void count_mistake(Summary *summary, int lab, const json_t *check, int row) {
    const char *kind = table_text(json_object_get(check, "cause"), "kind");
    int i = 0;
    while (i < summary->mistake_count &&
           !(summary->mistakes[i].lab == lab && strcmp(summary->mistakes[i].kind, kind) == 0))
        i++;
    if (!kind[0])
        return;
    if (i == summary->mistake_count) {
        summary->mistakes = grow(summary->mistakes, i, sizeof *summary->mistakes);
        SummaryMistake *mistake = &summary->mistakes[summary->mistake_count++];
        *mistake = (SummaryMistake){.lab = lab, .last = -1};
        snprintf(mistake->task, sizeof mistake->task, "%s", table_text(check, "task"));
        snprintf(mistake->kind, sizeof mistake->kind, "%s", kind);
    }
    summary->mistakes[i].students += summary->mistakes[i].last != row;
    summary->mistakes[i].last = row;
}

static int by_frequency(const void *a, const void *b) {
    const SummaryMistake *x = a, *y = b;
    if (x->students != y->students)
        return y->students - x->students;
    return x->lab != y->lab ? x->lab - y->lab : strcmp(x->kind, y->kind);
}

void summary_make(Summary *summary, const Book *book) {
    size_t i;
    const json_t *check;
    *summary = (Summary){.task_count = 0};
    for (int n = 0; n < book->table->plan->lab_count; n++) {
        count_lab(&summary->labs[n], book, n);
        for (int r = 0; r < book->count; r++) {
            find_items(summary, book, &book->rows[r], n);
            json_array_foreach(checks_of(book, &book->rows[r], n), i, check)
                count_mistake(summary, n, check, r);
        }
    }
    for (int t = 0; t < summary->task_count; t++)
        count_item(&summary->tasks[t], book);
    for (int c = 0; c < summary->check_count; c++)
        count_item(&summary->checks[c], book);
    if (summary->mistake_count > 0)
        qsort(summary->mistakes, (size_t)summary->mistake_count, sizeof *summary->mistakes, by_frequency);
}

void summary_destroy(Summary *summary) {
    free(summary->tasks);
    free(summary->checks);
    free(summary->mistakes);
    *summary = (Summary){.task_count = 0};
}
