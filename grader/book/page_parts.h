// What the parts of a class's page share.
#pragma once

#include "book/shared_sheets.h"
#include "book/summary.h"
#include "pages/page.h"

typedef struct ClassPage {
    Page page;
    const Book *book;
    char *const *names; // one a row, in the place of the students' names; NULL: nobody is hidden
    Summary summary;
} ClassPage;

// The name of a row's student, with a link to the page if there is one.
void page_part_link(ClassPage *page, const BookRow *row);

// A cell with a number, and one with a bar; `most` is as long as a bar gets.
void page_part_bar(ClassPage *page, const char *number, double value, double most);

// The labs: who handed in, passed, means, and how the points are spread.
void page_part_labs(ClassPage *page);

// Students and tasks at a glance.
void page_part_matrix(ClassPage *page);

// The hardest tasks, all checks, the commonest mistakes.
void page_part_tasks(ClassPage *page);

// Pairs of hand-ins with code in common, where this run looked for them.
void page_part_copies(ClassPage *page);

// Students whose predictions are of one sheet.
void page_part_sheets(ClassPage *page);

// Who is not graded, has no picture, has a note, is ignored.
void page_part_looks(ClassPage *page);
