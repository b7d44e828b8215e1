#include "book/page_parts.h"

#include <stdio.h>
#include <string.h>

// Full is what passes a check: all but a trace.
static int level(double share) {
    return share >= 0.95 ? 4 : share >= 0.5 ? 3 : share > 0 ? 2 : 1;
}

// How many tasks of the lab stand side by side, from task t on.
static int tasks_of(const Summary *summary, int t) {
    int count = 1;
    while (t + count < summary->task_count && summary->tasks[t + count].lab == summary->tasks[t].lab)
        count++;
    return count;
}

static void write_heads(ClassPage *page) {
    const Summary *summary = &page->summary;
    FILE *out = page->page.out;
    fputs("<thead><tr><td></td>", out);
    for (int t = 0; t < summary->task_count; t += tasks_of(summary, t))
        fprintf(out, "<th scope=\"colgroup\" colspan=\"%d\">lab %s</th>", tasks_of(summary, t),
                page->book->table->plan->labs[summary->tasks[t].lab]);
    fputs("</tr>\n<tr><th scope=\"col\">student</th>", out);
    for (int t = 0; t < summary->task_count; t++) {
        const char *dot = strchr(summary->tasks[t].task, '.');
        fprintf(out, "<th scope=\"col\"%s>",
                t == 0 || summary->tasks[t].lab != summary->tasks[t - 1].lab ? " class=\"first\"" : "");
        fprintf(out, "<abbr title=\"task %s\">%s</abbr></th>", summary->tasks[t].task, dot ? dot : "all");
    }
    fputs("</tr></thead>\n", out);
}

static void write_cell(ClassPage *page, const BookRow *row, int t) {
    const Summary *summary = &page->summary;
    const bool first = t == 0 || summary->tasks[t].lab != summary->tasks[t - 1].lab;
    const double share = summary_share(page->book, row, &summary->tasks[t]);
    if (share < 0)
        fprintf(page->page.out, "<td%s></td>", first ? " class=\"first\"" : "");
    else
        fprintf(page->page.out, "<td class=\"m%d%s\">%.0f</td>", level(share), first ? " first" : "",
                share >= 0.95 ? 100 : 100 * share);
}

static void write_means(ClassPage *page) {
    const Summary *summary = &page->summary;
    fputs("<tfoot><tr><th scope=\"row\">mean</th>", page->page.out);
    for (int t = 0; t < summary->task_count; t++)
        fprintf(page->page.out, "<td class=\"m%d\">%.0f</td>", level(summary->tasks[t].share),
                100 * summary->tasks[t].share);
    fputs("</tr></tfoot>\n", page->page.out);
}

void page_part_matrix(ClassPage *page) {
    FILE *out = page->page.out;
    if (page->summary.task_count == 0)
        return;
    fputs(
        "<h2>At a glance</h2>\n<p class=\"quiet\">Percent of each task's measured points: <span "
        "class=\"swatch m4\">95 and "
        "more</span> <span class=\"swatch m3\">50 to 94</span> <span class=\"swatch m2\">below 50</span> "
        "<span "
        "class=\"swatch m1\">none</span>; empty: not handed in or not graded.</p>\n"
        "<div class=\"wide glance\" tabindex=\"0\" role=\"region\" aria-label=\"Students and tasks\"><table>",
        out);
    write_heads(page);
    fputs("<tbody>\n", out);
    for (int r = 0; r < page->book->count; r++) {
        fputs("<tr><th scope=\"row\">", out);
        page_part_link(page, &page->book->rows[r]);
        fputs("</th>", out);
        for (int t = 0; t < page->summary.task_count; t++)
            write_cell(page, &page->book->rows[r], t);
        fputs("</tr>\n", out);
    }
    fputs("</tbody>\n", out);
    write_means(page);
    fputs("</table></div>\n", out);
}
