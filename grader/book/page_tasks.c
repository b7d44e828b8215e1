#include "book/page_parts.h"

#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SHOWN_TASKS = 10, SHOWN_MISTAKES = 20 };

static int by_share(const void *a, const void *b) {
    const SummaryItem *x = *(SummaryItem *const *)a, *y = *(SummaryItem *const *)b;
    if (x->share != y->share)
        return x->share < y->share ? -1 : 1;
    return x < y ? -1 : x > y;
}

static void write_item(ClassPage *page, const SummaryItem *item, bool named) {
    char text[24];
    fputs("<tr>", page->page.out);
    page_cell(&page->page, page->book->table->plan->labs[item->lab]);
    page_cell(&page->page, item->task);
    if (named)
        page_cell(&page->page, item->name);
    fprintf(page->page.out, "<td class=\"number\">%d of %d</td>", item->full, item->count);
    snprintf(text, sizeof text, "%.0f %%", 100 * item->share);
    page_part_bar(page, text, item->share, 1);
    fputs("</tr>\n", page->page.out);
}

static void write_hardest(ClassPage *page) {
    const Summary *summary = &page->summary;
    const SummaryItem **order = calloc((size_t)summary->task_count + 1, sizeof(const SummaryItem *));
    INVARIANT(order);
    for (int t = 0; t < summary->task_count; t++)
        order[t] = &summary->tasks[t];
    qsort(order, (size_t)summary->task_count, sizeof(const SummaryItem *), by_share);
    fputs("<h2>The hardest tasks</h2>\n", page->page.out);
    page_begin_table(&page->page, "The hardest tasks",
                     (const char *const[]){"lab", "task", "#have it", "#mean", "", NULL});
    for (int t = 0; t < summary->task_count && t < SHOWN_TASKS; t++)
        write_item(page, order[t], false);
    page_end_table(&page->page);
    free(order);
}

static void write_checks(ClassPage *page) {
    fprintf(page->page.out, "<details><summary>All %d checks</summary>\n", page->summary.check_count);
    page_begin_table(&page->page, "All checks",
                     (const char *const[]){"lab", "task", "check", "#have it", "#mean", "", NULL});
    for (int c = 0; c < page->summary.check_count; c++)
        write_item(page, &page->summary.checks[c], true);
    page_end_table(&page->page);
    fputs("</details>\n", page->page.out);
}

static void write_mistakes(ClassPage *page) {
    const Summary *summary = &page->summary;
    char text[24];
    fputs("<h2>The commonest mistakes</h2>\n", page->page.out);
    if (summary->mistake_count == 0) {
        fputs("<p>None.</p>\n", page->page.out);
        return;
    }
    page_begin_table(&page->page, "The commonest mistakes",
                     (const char *const[]){"lab", "task", "mistake", "#students", "", NULL});
    for (int i = 0; i < summary->mistake_count && i < SHOWN_MISTAKES; i++) {
        const SummaryMistake *mistake = &summary->mistakes[i];
        fputs("<tr>", page->page.out);
        page_cell(&page->page, page->book->table->plan->labs[mistake->lab]);
        page_cell(&page->page, mistake->task);
        page_cell(&page->page, mistake->kind);
        snprintf(text, sizeof text, "%d", mistake->students);
        page_part_bar(page, text, mistake->students, summary->mistakes[0].students);
        fputs("</tr>\n", page->page.out);
    }
    page_end_table(&page->page);
    if (summary->mistake_count > SHOWN_MISTAKES)
        fprintf(page->page.out, "<p class=\"quiet\">%d others are rarer.</p>\n",
                summary->mistake_count - SHOWN_MISTAKES);
}

void page_part_tasks(ClassPage *page) {
    if (page->summary.task_count > 0) {
        write_hardest(page);
        write_checks(page);
    }
    write_mistakes(page);
}
