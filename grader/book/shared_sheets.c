#include "book/shared_sheets.h"

#include "predict/prediction_sheet.h"
#include "scene/check.h"

#include <stdlib.h>
#include <string.h>

static long sheet_of(const Book *book, const BookRow *row, int lab) {
    if (row->entry < 0 || !table_is_graded(book->table, row->entry))
        return 0;
    const json_t *predictions = json_object_get(table_lab(book->table, row->entry, lab), "predictions");
    return (long)table_number(predictions, "sheet");
}

static bool is_same_student(const Book *book, int first, int second) {
    const BookRow *a = &book->rows[first], *b = &book->rows[second];
    return (a->student >= 0 && a->student == b->student) ||
           (strcmp(book_name(book, a), book_name(book, b)) == 0 &&
            strcmp(book_id(book, a), book_id(book, b)) == 0);
}

static int compare(const void *first, const void *second) {
    const SharedSheet *a = first, *b = second;
    if (a->lab != b->lab)
        return a->lab - b->lab;
    return a->sheet != b->sheet ? (a->sheet > b->sheet ? 1 : -1) : a->row - b->row;
}

// How many from `begin` on have its sheet. *several: not all of them are one student's.
static int group_at(const SharedSheets *all, int begin, const Book *book, bool *several) {
    int n = 1;
    *several = false;
    for (; begin + n < all->count; n++) {
        const SharedSheet *a = &all->list[begin], *b = &all->list[begin + n];
        if (a->lab != b->lab || a->sheet != b->sheet)
            break;
        *several = *several || !is_same_student(book, a->row, b->row);
    }
    return n;
}

static void keep_groups(SharedSheets *shared, const Book *book) {
    const SharedSheets all = *shared;
    shared->count = 0;
    for (int begin = 0, n; begin < all.count; begin += n) {
        bool several;
        n = group_at(&all, begin, book, &several);
        for (int i = begin; several && i < begin + n; i++)
            shared->list[shared->count++] = all.list[i];
    }
}

void shared_sheets_find(SharedSheets *shared, const Book *book) {
    const int labs = book->table->plan->lab_count;
    *shared = (SharedSheets){.list = calloc((size_t)(book->count * labs) + 1, sizeof *shared->list)};
    INVARIANT(shared->list);
    for (int n = 0; n < labs; n++) {
        int drawn = 0;
        for (int r = 0; r < book->count; r++) {
            const long sheet = sheet_of(book, &book->rows[r], n);
            if (sheet > 0)
                shared->list[shared->count + drawn++] = (SharedSheet){n, sheet, r};
        }
        shared->count += drawn;
        shared->by_chance += 0.5 * drawn * (drawn - 1) / PREDICTION_SHEETS;
    }
    qsort(shared->list, (size_t)shared->count, sizeof *shared->list, compare);
    keep_groups(shared, book);
}

void shared_sheets_destroy(SharedSheets *shared) {
    free(shared->list);
    *shared = (SharedSheets){0};
}
