// Puts the page of a class together, and ends it with the table of all students.
#include "book/class_page.h"

#include "book/page_parts.h"

#include <stdio.h>

void page_part_link(ClassPage *page, const BookRow *row) {
    const Table *table = page->book->table;
    const bool graded = row->entry >= 0 && table_is_graded(table, row->entry);
    const char *hidden = page->names ? page->names[row - page->book->rows] : NULL;
    if (graded)
        fprintf(page->page.out, "<a href=\"pages/%s.html\">",
                hidden ? hidden : table->roster->entries[row->entry].file);
    // Learning systems' names of folders are long: who it is comes from them.
    const bool told = row->entry < 0 || row->student >= 0 || table->roster->entries[row->entry].id[0];
    page_text(&page->page, hidden ? hidden
                           : told ? book_name(page->book, row)
                                  : table->roster->entries[row->entry].shown);
    fputs(graded ? "</a>" : "", page->page.out);
}

void page_part_bar(ClassPage *page, const char *number, double value, double most) {
    fprintf(page->page.out, "<td class=\"number\">%s</td><td aria-hidden=\"true\">", number);
    if (value > 0)
        fprintf(page->page.out, "<span class=\"bar\" style=\"width:%.2frem\"></span>", 14.0 * value / most);
    fputs("</td>", page->page.out);
}

static void write_row(ClassPage *page, const BookRow *row) {
    FILE *out = page->page.out;
    fputs("<tr><td class=\"name\">", out);
    page_part_link(page, row);
    fputs("</td>", out);
    for (int n = 0; n < page->book->table->plan->lab_count; n++) {
        const BookMark *mark = &row->marks[n];
        if (mark->known && (mark->overridden || mark->taken > 0))
            fprintf(out,
                    "<td class=\"number\" data-key=\"%.2f\">%.2f <span class=\"quiet\">(%.2f)</span></td>",
                    mark->points, mark->points, mark->score);
        else if (mark->known)
            fprintf(out, "<td class=\"number\">%.2f</td>", mark->points);
        else
            fputs("<td class=\"number\"></td>", out);
    }
    fputs("<td class=\"number\">", out);
    if (book_has_points(page->book, row))
        fprintf(out, "%.2f", row->total);
    fprintf(out, "</td><td>%s</td></tr>\n", book_status(page->book, row));
}

static void write_all(ClassPage *page) {
    FILE *out = page->page.out;
    fputs("<h2>All students</h2>\n", out);
    if (page->book->ruled)
        fputs("<p class=\"quiet\">Points that count; where they are others than measured, those stand in "
              "brackets.</p>\n",
              out);
    fputs("<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"All "
          "students\"><table><thead><tr><th "
          "scope=\"col\" aria-sort=\"ascending\"><button>student</button></th>",
          out);
    for (int n = 0; n < page->book->table->plan->lab_count; n++)
        fprintf(out, "<th scope=\"col\" class=\"number\"><button>lab %s</button></th>",
                page->book->table->plan->labs[n]);
    fputs("<th scope=\"col\" class=\"number\"><button>total</button></th><th "
          "scope=\"col\"><button>status</button></th></tr>"
          "</thead><tbody>\n",
          out);
    for (int r = 0; r < page->book->count; r++)
        write_row(page, &page->book->rows[r]);
    page_end_table(&page->page);
}

static void write_counts(ClassPage *page) {
    const Table *table = page->book->table;
    int graded = 0, missing = 0;
    for (int r = 0; r < page->book->count; r++) {
        const int entry = page->book->rows[r].entry;
        missing += entry < 0;
        graded += entry >= 0 && table_is_graded(table, entry);
    }
    fprintf(page->page.out, "<p>%d submissions, %d graded, %d not graded", table->roster->count, graded,
            table->roster->count - graded);
    if (page->book->listed)
        fprintf(page->page.out, ", %d students handed in nothing", missing);
    fprintf(page->page.out, " <span class=\"quiet\">(seed %llu)</span></p>\n",
            (unsigned long long)table->plan->seed);
    const int by_files = page->book->late.given ? book_count_by_files(page->book) : 0;
    if (by_files > 0)
        fprintf(page->page.out,
                "<p>When %d of them were handed in is known by the files' times only, which a student can "
                "set.</p>\n",
                by_files);
}

char *class_page(const Book *book, char *const *names) {
    ClassPage page = {.book = book, .names = names};
    if (!page_begin(&page.page, "Shadow Lab: the class"))
        return NULL;
    summary_make(&page.summary, book);
    write_counts(&page);
    page_part_labs(&page);
    page_part_matrix(&page);
    page_part_tasks(&page);
    page_part_looks(&page);
    page_part_sheets(&page);
    page_part_copies(&page);
    write_all(&page);
    summary_destroy(&page.summary);
    return page_end(&page.page);
}
