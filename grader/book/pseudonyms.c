// Reads the pseudonyms that are known, draws those that are missing, and writes the file again.
#include "book/pseudonyms.h"

#include "base/csv_write.h"
#include "scene/check.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>

enum { NAME = 2 + 8 };

typedef struct Pseudonyms {
    Csv known; // of the file; zeroed when there is none
    int student, pseudonym;
    FILE *out; // the new file
    char **names;
    int count;
} Pseudonyms;

// What of a student stays from run to run.
static const char *key_of(const Book *book, const BookRow *row) {
    const char *id = book_id(book, row);
    return id[0] ? id : book_name(book, row);
}

static bool read_known(Pseudonyms *all, const char *file) {
    if (!files_exists(file))
        return true;
    if (!csv_read(&all->known, file))
        return false;
    all->student = csv_column(&all->known, (const char *const[]){"student", NULL});
    all->pseudonym = csv_column(&all->known, (const char *const[]){"pseudonym", NULL});
    return (all->student >= 0 && all->pseudonym >= 0) ||
           csv_fail(&all->known, -1, "these are no pseudonyms: give a file that is not there yet");
}

static const char *known_name(const Pseudonyms *all, const char *key) {
    for (int i = 0; i < all->known.count; i++)
        if (strcmp(csv_cell(&all->known, i, all->student), key) == 0)
            return csv_cell(&all->known, i, all->pseudonym);
    return NULL;
}

static bool is_taken(const Pseudonyms *all, const char *name) {
    for (int i = 0; i < all->known.count; i++)
        if (strcmp(csv_cell(&all->known, i, all->pseudonym), name) == 0)
            return true;
    for (int i = 0; i < all->count; i++)
        if (strcmp(all->names[i], name) == 0)
            return true;
    return false;
}

static bool draw(const Pseudonyms *all, char name[NAME + 1]) {
    do {
        uint32_t bits;
        if (getrandom(&bits, sizeof bits, 0) != sizeof bits)
            return check_fail("no random numbers: %s", strerror(errno));
        snprintf(name, NAME + 1, "s-%08x", bits);
    } while (is_taken(all, name));
    return true;
}

static void keep(const Pseudonyms *all, const char *key, const char *name) {
    csv_write_cell(all->out, key);
    fputc(',', all->out);
    csv_write_cell(all->out, name);
    fputc('\n', all->out);
}

static bool name_all(Pseudonyms *all, const char *const *keys, int count) {
    char drawn[NAME + 1];
    for (int r = 0; r < count; r++) {
        const char *key = keys[r], *name = known_name(all, key);
        for (int s = 0; !name && s < r; s++) // another hand-in of the same student
            if (strcmp(keys[s], key) == 0)
                name = all->names[s];
        if (!name) {
            if (!draw(all, drawn))
                return false;
            keep(all, key, name = drawn);
        }
        all->names[all->count] = strdup(name);
        INVARIANT(all->names[all->count]);
        all->count++;
    }
    return true;
}

static bool write_file(const char *file, const char *text) {
    return files_write_whole(file, text, true) &&
           (chmod(file, 0600) == 0 || check_fail("%s cannot be kept from others: %s", file, strerror(errno)));
}

bool pseudonyms_of(char ***names, const char *const *keys, int count, const char *file) {
    Pseudonyms all = {.names = calloc((size_t)count + 1, sizeof *all.names)};
    char *text = NULL;
    size_t size;
    all.out = open_memstream(&text, &size);
    INVARIANT(all.names && all.out);
    bool ok = read_known(&all, file);
    fputs("student,pseudonym\n", all.out);
    for (int i = 0; ok && i < all.known.count; i++)
        keep(&all, csv_cell(&all.known, i, all.student), csv_cell(&all.known, i, all.pseudonym));
    ok = ok && name_all(&all, keys, count);
    fclose(all.out);
    ok = ok && write_file(file, text);
    free(text);
    csv_destroy(&all.known);
    *names = all.names;
    if (!ok) {
        pseudonyms_free(all.names);
        *names = NULL;
    }
    return ok;
}

bool pseudonyms_make(char ***names, const Book *book, const char *file) {
    const char **keys = calloc((size_t)book->count + 1, sizeof *keys);
    INVARIANT(keys);
    for (int r = 0; r < book->count; r++)
        keys[r] = key_of(book, &book->rows[r]);
    const bool ok = pseudonyms_of(names, keys, book->count, file);
    free(keys);
    return ok;
}

void pseudonyms_free(char **names) {
    for (char **name = names; name && *name; name++)
        free(*name);
    free(names);
}
