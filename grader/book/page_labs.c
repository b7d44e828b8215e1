#include "book/page_parts.h"

#include <stdio.h>

// Eleven small columns, and the same in words.
static void write_spread(ClassPage *page, const SummaryLab *lab) {
    FILE *out = page->page.out;
    int most = 1;
    for (int b = 0; b < SUMMARY_BINS; b++)
        most = lab->bins[b] > most ? lab->bins[b] : most;
    fputs("<td><span class=\"spread\" role=\"img\" aria-label=\"", out);
    for (int b = 0; b < SUMMARY_BINS - 1; b++)
        fprintf(out, "%d from %d %%, ", lab->bins[b], 10 * b);
    fprintf(out, "%d with 100 %%\">", lab->bins[SUMMARY_BINS - 1]);
    for (int b = 0; b < SUMMARY_BINS; b++)
        fprintf(out, "<i style=\"height:%.0f%%\"></i>", 100.0 * lab->bins[b] / most);
    fputs("</span></td>", out);
}

static void write_lab(ClassPage *page, int n) {
    const SummaryLab *lab = &page->summary.labs[n];
    FILE *out = page->page.out;
    fprintf(out, "<tr><th scope=\"row\">%s</th>", page->book->table->plan->labs[n]);
    page_cell(&page->page, lab->name);
    fprintf(out, "<td class=\"number\">%d</td><td class=\"number\">%d</td>", lab->count, lab->passed);
    if (lab->count > 0)
        fprintf(out,
                "<td class=\"number\">%.2f</td><td class=\"number\">%.2f</td><td class=\"number\">%.0f</td>",
                lab->mean, lab->median, lab->maximum);
    else
        fputs("<td></td><td></td><td></td>", out);
    write_spread(page, lab);
    fputs("</tr>\n", out);
}

void page_part_labs(ClassPage *page) {
    fputs("<h2>Labs</h2>\n<p class=\"quiet\">Who handed in nothing of a lab is no part of its means. The "
          "columns "
          "on the right: how many have 0 to 9 %, ... 90 to 99 %, and all of the points.</p>\n",
          page->page.out);
    page_begin_table(&page->page, "Labs",
                     (const char *const[]){"lab", "name", "#handed in", "#passed", "#mean", "#median",
                                           "#of points", "spread", NULL});
    for (int n = 0; n < page->book->table->plan->lab_count; n++)
        write_lab(page, n);
    page_end_table(&page->page);
}
