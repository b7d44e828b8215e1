// Writes who needs a look, who handed in nothing, and what was ignored.
#include "book/page_parts.h"

#include <stdio.h>
#include <string.h>

static void look_row(ClassPage *page, const BookRow *row, const char *lab, const char *what,
                     const char *message) {
    char first[200];
    snprintf(first, sizeof first, "%s", message);
    for (char *end; (end = strchr(first, '\n'));)
        *end = ' ';
    fputs("<tr><td class=\"name\">", page->page.out);
    page_part_link(page, row);
    fputs("</td>", page->page.out);
    page_cell(&page->page, lab);
    page_cell(&page->page, what);
    page_cell(&page->page, first);
    fputs("</tr>\n", page->page.out);
}

static const char *message_of(const ClassPage *page, const BookRow *row, int n) {
    return table_text(table_lab(page->book->table, row->entry, n), "message");
}

static bool needs_look(const ClassPage *page, const BookRow *row) {
    if (row->entry < 0)
        return false;
    bool needs = !table_is_graded(page->book->table, row->entry) || row->note;
    for (int n = 0; !needs && n < page->book->table->plan->lab_count; n++)
        needs = row->marks[n].handed_in && message_of(page, row, n)[0];
    return needs;
}

static void write_look(ClassPage *page, const BookRow *row) {
    const Table *table = page->book->table;
    if (!table_is_graded(table, row->entry))
        look_row(page, row, "all", "not graded", table_reason(table, row->entry));
    for (int n = 0; n < table->plan->lab_count; n++)
        if (row->marks[n].handed_in && message_of(page, row, n)[0])
            look_row(page, row, table->plan->labs[n], table_text(table_lab(table, row->entry, n), "status"),
                     message_of(page, row, n));
    if (row->note)
        look_row(page, row, "all", "note", row->note);
}

static void write_looks(ClassPage *page) {
    int count = 0;
    for (int r = 0; r < page->book->count; r++)
        count += needs_look(page, &page->book->rows[r]);
    if (count == 0) {
        fputs("<p>Nobody.</p>\n", page->page.out);
        return;
    }
    page_begin_table(&page->page, "Who needs a look",
                     (const char *const[]){"student", "lab", "status", "message", NULL});
    for (int r = 0; r < page->book->count; r++)
        if (needs_look(page, &page->book->rows[r]))
            write_look(page, &page->book->rows[r]);
    page_end_table(&page->page);
}

static void write_missing(ClassPage *page) {
    int count = 0;
    for (int r = 0; r < page->book->count; r++)
        count += page->book->rows[r].entry < 0;
    if (count == 0)
        return;
    fprintf(page->page.out, "<p>%d handed in nothing:</p>\n<ul>\n", count);
    for (int r = 0; r < page->book->count; r++)
        if (page->book->rows[r].entry < 0) {
            fputs("<li>", page->page.out);
            page_part_link(page, &page->book->rows[r]);
            if (page->book->rows[r].note) {
                fputs(" <span class=\"quiet\">", page->page.out);
                page_text(&page->page, page->book->rows[r].note);
                fputs("</span>", page->page.out);
            }
            fputs("</li>\n", page->page.out);
        }
    fputs("</ul>\n", page->page.out);
}

static void write_ignored(ClassPage *page) {
    const Roster *roster = page->book->table->roster;
    if (roster->ignored_count == 0 || page->names)
        return;
    fputs("<p>Ignored in the class's folder:</p>\n<ul>\n", page->page.out);
    for (int i = 0; i < roster->ignored_count; i++) {
        fputs("<li>", page->page.out);
        page_text(&page->page, roster->ignored[i].name);
        fprintf(page->page.out, " <span class=\"quiet\">%s</span></li>\n", roster->ignored[i].why);
    }
    fputs("</ul>\n", page->page.out);
}

void page_part_looks(ClassPage *page) {
    fputs("<h2>Who needs a look</h2>\n<p>Not graded for a reason of the grader's, nothing could be drawn or "
          "only a "
          "part, or there is a note.</p>\n",
          page->page.out);
    write_looks(page);
    write_missing(page);
    write_ignored(page);
}
