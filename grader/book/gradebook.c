// Puts together what becomes of the records, writes it, and says what people should know.
#include "book/gradebook.h"

#include "book/anonymous.h"
#include "book/class_page.h"
#include "book/grades_csv.h"
#include "book/shared_sheets.h"
#include "copies/copies.h"

#include <stdio.h>
#include <stdlib.h>

bool gradebook_gives_away(const GradebookSettings *wanted) {
    bool away = wanted->anonymous;
    for (int k = 0; k < EXPORT_KINDS; k++)
        away = away || wanted->exports[k];
    return away;
}

bool gradebook_is_asked_for(const GradebookSettings *wanted) {
    const BookFiles *files = &wanted->files;
    return files->roster || files->overrides || files->late || wanted->no_points || wanted->copies ||
           gradebook_gives_away(wanted);
}

static bool write_page(const Book *book, const char *output) {
    char path[FILES_PATH], *page = class_page(book, NULL);
    files_join(path, output, "index.html");
    const bool ok = page && files_write_whole(path, page, true);
    free(page);
    return ok;
}

static void say_list(const Book *book) {
    int missing = 0;
    for (int r = 0; r < book->count; r++) {
        const BookRow *row = &book->rows[r];
        missing += row->entry < 0;
        if (book->listed && row->student < 0)
            fprintf(stderr, "grade: roster: \"%s\": %s\n", book->table->roster->entries[row->entry].shown,
                    row->note);
    }
    if (missing > 0)
        fprintf(stderr, "grade: roster: %d of %d handed in nothing\n", missing, book->list.count);
}

static void say_times(const Book *book) {
    const int count = book->late.given ? book_count_by_files(book) : 0;
    if (count > 0)
        fprintf(
            stderr,
            "grade: due: of %d only the files' times tell when they were handed in, which a student can set: "
            "give a list with the learning system's times\n",
            count);
}

static void say_stale(const Book *book) {
    const Table *table = book->table;
    const char *first = NULL;
    int count = 0;
    for (int i = 0; i < table->roster->count; i++)
        if (table->stale[i][0]) {
            first = first ? first : table->stale[i];
            count++;
        }
    if (count > 0)
        fprintf(stderr, "grade: %d were graded with %s than today's: --resume grades them again\n", count,
                first);
}

static void say_sheets(const SharedSheets *shared, const char *output) {
    if (shared->count > 0)
        fprintf(stderr,
                "grade: %d hand-ins have predictions with the sheet of somebody else: %s/index.html\n",
                shared->count, output);
}

static bool find_copies(Copies *copies, const Table *table, const ClassSettings *settings) {
    if (!copies_find(copies, table, settings) || !copies_write(copies, table, settings->output))
        return false;
    printf("%d pairs of hand-ins have code in common: %s/copies.csv\n", copies->count, settings->output);
    return true;
}

bool gradebook_write(const Table *table, const ClassSettings *settings, void *context) {
    const GradebookSettings *wanted = context;
    Book book;
    Copies copies = {.count = 0};
    SharedSheets sheets;
    if (!book_open(&book, table, settings->output, &wanted->files))
        return false;
    shared_sheets_find(&sheets, &book);
    book.sheets = &sheets;
    bool ok = grades_csv_write(settings->output, &book) &&
              export_write(&book, settings->output, wanted->exports, wanted->no_points) &&
              (!wanted->anonymous ||
               anonymous_write(&book, settings->output, wanted->anonymous, wanted->no_points));
    const bool compared = !wanted->copies || !ok || find_copies(&copies, table, settings);
    book.copies = wanted->copies && compared ? &copies : NULL;
    ok = ok && write_page(&book, settings->output); // also where pairs could not be looked for
    if (!settings->only) {
        say_list(&book);
        say_times(&book);
        say_stale(&book);
        say_sheets(&sheets, settings->output);
    }
    shared_sheets_destroy(&sheets);
    book_close(&book);
    copies_destroy(&copies);
    return ok && compared;
}
