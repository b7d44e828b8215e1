// Copies the book with its rows in the order of pseudonyms, and writes tables and pages of the copy.
#include "book/anonymous.h"

#include "book/class_page.h"
#include "book/feedback_page.h"
#include "book/pseudonyms.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct NamedRow {
    BookRow row;
    char *name;
} NamedRow;

static int by_name(const void *a, const void *b) {
    return strcmp(((const NamedRow *)a)->name, ((const NamedRow *)b)->name);
}

// The order of the rows tells names, and so may notes.
static void shuffle(Book *book, char **names) {
    NamedRow *rows = calloc((size_t)book->count + 1, sizeof *rows);
    INVARIANT(rows);
    for (int r = 0; r < book->count; r++)
        rows[r] = (NamedRow){book->rows[r], names[r]};
    qsort(rows, (size_t)book->count, sizeof *rows, by_name);
    for (int r = 0; r < book->count; r++) {
        book->rows[r] = rows[r].row;
        book->rows[r].note = NULL;
        names[r] = rows[r].name;
    }
    free(rows);
}

static bool write_pages(const Book *book, char *const *names, const char *output, const char *folder,
                        bool no_points) {
    char path[FILES_PATH], file[64];
    for (int r = 0; r < book->count; r++) {
        const int entry = book->rows[r].entry;
        if (entry < 0 || !table_is_graded(book->table, entry))
            continue;
        snprintf(file, sizeof file, "pages/%.50s.html", names[r]);
        files_join(path, folder, file);
        if (!feedback_page_copy(path, output, &book->table->roster->entries[entry], names[r], no_points))
            return false;
    }
    return true;
}

static bool write_grades(const Book *book, char *const *names, const char *folder) {
    char path[FILES_PATH], *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    INVARIANT(out);
    fputs("student", out);
    for (int n = 0; n < book->table->plan->lab_count; n++)
        fprintf(out, ",lab %s", book->table->plan->labs[n]);
    fputs(",total,status\n", out);
    for (int r = 0; r < book->count; r++) {
        const BookRow *row = &book->rows[r];
        fputs(names[r], out);
        for (int n = 0; n < book->table->plan->lab_count; n++) {
            fputc(',', out);
            if (row->marks[n].known)
                fprintf(out, "%.2f", row->marks[n].points);
        }
        fputc(',', out);
        if (book_has_points(book, row))
            fprintf(out, "%.2f", row->total);
        fprintf(out, ",%s\n", book_status(book, row));
    }
    fclose(out);
    files_join(path, folder, "grades.csv");
    const bool ok = files_write_whole(path, text, true);
    free(text);
    return ok;
}

static bool write_index(const Book *book, char *const *names, const char *folder) {
    char path[FILES_PATH], *page = class_page(book, names);
    files_join(path, folder, "index.html");
    const bool ok = page && files_write_whole(path, page, true);
    free(page);
    return ok;
}

bool anonymous_write(const Book *book, const char *output, const char *file, bool no_points) {
    char folder[FILES_PATH], pages[FILES_PATH], **names;
    Book hidden = *book;
    if (!pseudonyms_make(&names, book, file))
        return false;
    hidden.rows = calloc((size_t)book->count + 1, sizeof *hidden.rows);
    INVARIANT(hidden.rows);
    memcpy(hidden.rows, book->rows, (size_t)book->count * sizeof *hidden.rows);
    shuffle(&hidden, names);
    files_join(folder, output, "anonymous");
    files_join(pages, folder, "pages");
    files_remove(folder); // pages of an earlier run
    const bool ok = files_make_folder(pages) && write_pages(&hidden, names, output, folder, no_points) &&
                    write_grades(&hidden, names, folder) && write_index(&hidden, names, folder);
    pseudonyms_free(names);
    free(hidden.rows);
    return ok;
}
