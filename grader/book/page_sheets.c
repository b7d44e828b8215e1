#include "book/page_parts.h"

#include <math.h>
#include <stdio.h>

enum { MOST_SHOWN = 100 };

static void write_sheet(ClassPage *page, const SharedSheet *shared) {
    const BookRow *row = &page->book->rows[shared->row];
    fputs("<tr>", page->page.out);
    page_cell(&page->page, page->book->table->plan->labs[shared->lab]);
    fprintf(page->page.out, "<td class=\"number\">%ld</td><td class=\"name\">", shared->sheet);
    page_part_link(page, row);
    fprintf(page->page.out, "</td><td class=\"number\">%.2f</td></tr>\n", row->marks[shared->lab].score);
}

void page_part_sheets(ClassPage *page) {
    const SharedSheets *shared = page->book->sheets;
    if (!shared || shared->count == 0 || page->names)
        return;
    fprintf(
        page->page.out,
        "<h2>One sheet of predictions</h2>\n<p>Each student's questions have numbers of their own, drawn "
        "once. "
        "These have the numbers of somebody else: of one file, or of one repository that both began with. By "
        "chance %s%.2f pairs are to be expected.</p>\n",
        shared->by_chance < 0.01 ? "less than " : "", fmax(shared->by_chance, 0.01));
    page_begin_table(&page->page, "One sheet of predictions",
                     (const char *const[]){"lab", "#sheet", "student", "#points", NULL});
    for (int i = 0; i < shared->count && i < MOST_SHOWN; i++)
        write_sheet(page, &shared->list[i]);
    page_end_table(&page->page);
    if (shared->count > MOST_SHOWN)
        fprintf(page->page.out, "<p>%d more are not shown.</p>\n", shared->count - MOST_SHOWN);
}
