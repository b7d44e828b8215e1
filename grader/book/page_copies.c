#include "book/page_parts.h"

#include <stdio.h>

enum { MOST_SHOWN = 100 };

static void write_student(ClassPage *page, int entry, int lab) {
    const BookRow *row = &page->book->rows[entry]; // the entries' rows come first, in their order
    fputs("<td class=\"name\">", page->page.out);
    page_part_link(page, row);
    fputs("</td><td class=\"number\">", page->page.out);
    if (row->marks[lab].measured)
        fprintf(page->page.out, "%.2f", row->marks[lab].score);
    fputs("</td>", page->page.out);
}

static void write_pair(ClassPage *page, const CopyPair *pair) {
    fputs("<tr>", page->page.out);
    page_cell(&page->page, page->book->table->plan->labs[pair->lab]);
    fprintf(page->page.out, "<td class=\"number\">%.0f</td>", pair->percent);
    page_cell(&page->page, copies_equal_name(pair->equal));
    write_student(page, pair->first, pair->lab);
    write_student(page, pair->second, pair->lab);
    fputs("</tr>\n", page->page.out);
}

static void write_pairs(ClassPage *page, const Copies *copies) {
    page_begin_table(&page->page, "Code in common",
                     (const char *const[]){"lab", "#percent", "the same", "first", "#its points", "second",
                                           "#its points", NULL});
    for (int i = 0; i < copies->count && i < MOST_SHOWN; i++)
        write_pair(page, &copies->pairs[i]);
    page_end_table(&page->page);
    if (copies->count > MOST_SHOWN)
        fprintf(page->page.out, "<p>%d more stand in copies.csv.</p>\n", copies->count - MOST_SHOWN);
}

void page_part_copies(ClassPage *page) {
    const Copies *copies = page->book->copies;
    if (!copies || page->names)
        return;
    fputs(
        "<h2>Code in common</h2>\n<p>A pair is a reason to look, and no proof. Percent are of what is "
        "neither "
        "handed out nor how many write it; comments, layout and names are taken away. \"All but names\" may "
        "have other points: a wrong name is no other code.</p>\n",
        page->page.out);
    if (copies->count == 0)
        fputs("<p>No pair.</p>\n", page->page.out);
    else
        write_pairs(page, copies);
}
