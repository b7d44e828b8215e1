#include "book/export.h"

#include "base/files.h"
#include "base/printable.h"
#include "book/export_csv.h"
#include "book/export_sqlite.h"
#include "book/feedback_page.h"
#include "scene/check.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const names[EXPORT_KINDS] = {"canvas", "moodle", "gradescope", "sqlite"};

bool export_take(void *target, const char *name) {
    bool *kinds = target;
    for (int k = 0; k < EXPORT_KINDS; k++)
        if (strcmp(names[k], name) == 0)
            return kinds[k] = true;
    return check_fail("takes canvas, moodle, gradescope or sqlite, not \"%s\"", name);
}

// An id may be any text: one that is no plain name of a file is written as those of records are.
static void file_of(char file[FILES_PATH], const char *id) {
    bool plain = isalnum((unsigned char)id[0]) && strlen(id) < 100;
    for (const char *at = id; *at; at++)
        plain = plain && (unsigned char)*at < 0x80 && (isalnum((unsigned char)*at) || strchr("._-@", *at));
    if (plain)
        snprintf(file, ESCAPE_FILE_NAME + 100, "%s", id);
    else
        printable_file_name(file, id);
}

static bool write_feedback(const Book *book, const char *output, bool no_points) {
    char folder[FILES_PATH], file[FILES_PATH], path[FILES_PATH];
    files_join(folder, output, "export/feedback");
    files_remove(folder); // pages of an earlier export
    bool ok = files_make_folder(folder);
    for (const BookRow *row = book->rows; ok && row < book->rows + book->count; row++) {
        if (row->entry < 0 || !book_counts(book, row) || !table_is_graded(book->table, row->entry))
            continue;
        const char *id = book_id(book, row);
        file_of(file, id[0] ? id : book_name(book, row));
        strcat(file, ".html");
        files_join(path, folder, file);
        ok = feedback_page_copy(path, output, &book->table->roster->entries[row->entry], NULL, no_points);
    }
    return ok;
}

bool export_write(const Book *book, const char *output, const bool kinds[EXPORT_KINDS], bool no_points) {
    char folder[FILES_PATH];
    bool wanted = false;
    for (int k = 0; k < EXPORT_KINDS; k++)
        wanted = wanted || kinds[k];
    if (!wanted)
        return true;
    files_join(folder, output, "export");
    return files_make_folder(folder) && (!kinds[EXPORT_CANVAS] || export_canvas(book, folder)) &&
           (!kinds[EXPORT_MOODLE] || export_moodle(book, folder)) &&
           (!kinds[EXPORT_GRADESCOPE] || export_gradescope(book, folder)) &&
           (!kinds[EXPORT_SQLITE] || export_sqlite(book, folder)) && write_feedback(book, output, no_points);
}
