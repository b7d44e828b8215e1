// Makes a fingerprint of each lab of each hand-in, drops what many have, and compares all pairs.
#include "copies/copies.h"

#include "base/csv_write.h"
#include "base/find_file.h"
#include "base/places.h"
#include "compile/rubric_file.h"
#include "copies/fingerprint.h"
#include "intake/submission.h"
#include "jail/jail_choose.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_SOURCE = 1 << 20, LEAST_OWN = 8, MOST_PAIRS = 500 };
static const double least_share = 0.5;

typedef struct CopyLab {
    Rubric rubric;
    CodePrint given, *prints; // one a hand-in
} CopyLab;

typedef struct Overlap {
    int first, second, common, own; // own: the hashes of the one that has fewer
    CopyEqual equal;
} Overlap;

// The lab's files in the folder, one after the other; "" when there are none.
static char *read_lab(const Rubric *rubric, const char *folder) {
    char *all = NULL;
    size_t size;
    FILE *out = open_memstream(&all, &size);
    INVARIANT(out);
    for (int i = 0; folder && i < rubric->file_count; i++) {
        char *text = find_file_read(folder, rubric->files[i], MOST_SOURCE);
        fputs(text ? text : "", out);
        fputc('\n', out);
        free(text);
    }
    fclose(out);
    check_clear();
    return all;
}

static bool open_lab(CopyLab *lab, const char *id, int count) {
    char folder[FILES_PATH], labs[FILES_PATH];
    *lab = (CopyLab){.prints = calloc((size_t)count + 1, sizeof *lab->prints)};
    INVARIANT(lab->prints);
    if (!places_find_lab(folder, id) || !rubric_load(&lab->rubric, folder))
        return check_fail("there is no lab %s in solutions/", id);
    places_path(labs, "labs");
    if (!places_find_lab_in(folder, labs, id))
        return check_fail("labs/ has no lab %s: what was handed out cannot be told from what was copied", id);
    char *text = read_lab(&lab->rubric, folder);
    lab->given = fingerprint_of_given(text);
    free(text);
    return true;
}

static void close_lab(CopyLab *lab, int count) {
    for (int i = 0; lab->prints && i < count; i++)
        fingerprint_destroy(&lab->prints[i]);
    free(lab->prints);
    fingerprint_destroy(&lab->given);
    rubric_destroy(&lab->rubric);
}

// What cannot be opened has no code of its own.
static void read_hand_in(const Table *table, int i, const Jail *jail, CopyLab *labs) {
    static Submission submission; // too large for a stack
    char path[FILES_PATH], note[600];
    bool made = false;
    if (!roster_fetch(table->roster, &table->roster->entries[i], path, &made))
        return;
    if (submission_open(&submission, jail, path) == EXTRACT_OK)
        for (int n = 0; n < table->plan->lab_count; n++) {
            const char *folder = submission_find_of(&submission, table->plan->labs[n], table->plan->lab_count,
                                                    note, sizeof note);
            char *text = read_lab(&labs[n].rubric, folder);
            labs[n].prints[i] = fingerprint_make(text, &labs[n].given);
            free(text);
        }
    submission_close(&submission);
    if (made)
        files_remove(path);
    check_clear();
}

static int by_value(const void *a, const void *b) {
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return x < y ? -1 : x > y;
}

// The hashes that more than `most` hand-ins have.
static CodePrint find_frequent(const CopyLab *lab, int count, int most) {
    size_t total = 0, at = 0;
    for (int i = 0; i < count; i++)
        total += (size_t)lab->prints[i].count;
    CodePrint all = {.hashes = calloc(total + 1, sizeof *all.hashes)};
    INVARIANT(all.hashes);
    for (int i = 0; i < count; at += (size_t)lab->prints[i++].count)
        if (lab->prints[i].count > 0)
            memcpy(all.hashes + at, lab->prints[i].hashes, (size_t)lab->prints[i].count * sizeof *all.hashes);
    qsort(all.hashes, total, sizeof *all.hashes, by_value);
    for (size_t begin = 0, end; begin < total; begin = end) {
        const uint64_t hash = all.hashes[begin];
        for (end = begin; end < total && all.hashes[end] == hash;)
            end++;
        if (end - begin > (size_t)most)
            all.hashes[all.count++] = hash;
    }
    return all;
}

static void drop(CodePrint *print, const CodePrint *frequent) {
    int kept = 0;
    for (int i = 0; i < print->count; i++)
        if (frequent->count == 0 || !bsearch(&print->hashes[i], frequent->hashes, (size_t)frequent->count,
                                             sizeof *frequent->hashes, by_value))
            print->hashes[kept++] = print->hashes[i];
    print->count = kept;
}

static int by_share(const void *a, const void *b) {
    const Overlap *x = a, *y = b;
    const long left = (long)x->common * y->own, right = (long)y->common * x->own;
    if (x->equal != y->equal)
        return x->equal > y->equal ? -1 : 1;
    if (left != right)
        return left > right ? -1 : 1;
    return x->first != y->first ? x->first - y->first : x->second - y->second;
}

static Overlap compare(const CopyLab *lab, int first, int second) {
    const CodePrint *a = &lab->prints[first], *b = &lab->prints[second];
    return (Overlap){first, second, fingerprint_common(a, b), a->count < b->count ? a->count : b->count,
                     a->named == b->named   ? COPY_EVERY_WORD
                     : a->whole == b->whole ? COPY_BUT_NAMES
                                            : COPY_DIFFERS};
}

// Those that look copied, the most alike first; *pairs is to be freed.
static int find_overlaps(Overlap **pairs, const CopyLab *lab, const bool *own, int count) {
    int found = 0;
    for (int i = 0; i < count; i++)
        for (int j = i + 1; j < count; j++) {
            const Overlap pair = compare(lab, i, j);
            if (!own[i] || !own[j] ||
                !(pair.equal || (pair.own >= LEAST_OWN && pair.common >= least_share * pair.own)))
                continue;
            if ((found & (found - 1)) == 0) { // room is always a power of two
                *pairs = realloc(*pairs, sizeof **pairs * (size_t)(found ? 2 * found : 1));
                INVARIANT(*pairs);
            }
            (*pairs)[found++] = pair;
        }
    if (found > 0)
        qsort(*pairs, (size_t)found, sizeof **pairs, by_share);
    return found;
}

static void keep(Copies *copies, const Overlap *pairs, int count, int lab) {
    copies->pairs = realloc(copies->pairs, sizeof *copies->pairs * (size_t)(copies->count + count + 1));
    INVARIANT(copies->pairs);
    for (int i = 0; i < count; i++)
        copies->pairs[copies->count++] =
            (CopyPair){lab, pairs[i].first, pairs[i].second,
                       pairs[i].equal ? 100 : 100.0 * pairs[i].common / pairs[i].own, pairs[i].equal};
}

static void find_in_lab(Copies *copies, CopyLab *lab, int number, int count) {
    CodePrint frequent = find_frequent(lab, count, 4 + count / 10);
    bool *own = calloc((size_t)count + 1, sizeof *own); // is there anything of their own?
    Overlap *pairs = NULL;
    INVARIANT(own);
    for (int i = 0; i < count; i++) {
        own[i] = lab->prints[i].count >= LEAST_OWN;
        drop(&lab->prints[i], &frequent);
    }
    const int found = find_overlaps(&pairs, lab, own, count);
    keep(copies, pairs, found < MOST_PAIRS ? found : MOST_PAIRS, number);
    free(pairs);
    free(own);
    fingerprint_destroy(&frequent);
}

const char *copies_equal_name(CopyEqual equal) {
    return equal == COPY_EVERY_WORD ? "every word" : equal == COPY_BUT_NAMES ? "all but names" : "";
}

bool copies_write(const Copies *copies, const Table *table, const char *output) {
    char path[FILES_PATH], *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    INVARIANT(out);
    fputs("lab,percent,equal,first,second\n", out);
    for (int i = 0; i < copies->count; i++) {
        const CopyPair *pair = &copies->pairs[i];
        fprintf(out, "%s,%.0f,%s,", table->plan->labs[pair->lab], pair->percent,
                copies_equal_name(pair->equal));
        csv_write_cell(out, table->roster->entries[pair->first].shown);
        fputc(',', out);
        csv_write_cell(out, table->roster->entries[pair->second].shown);
        fputc('\n', out);
    }
    fclose(out);
    files_join(path, output, "copies.csv");
    const bool ok = files_write_whole(path, text, true);
    free(text);
    return ok;
}

bool copies_find(Copies *copies, const Table *table, const ClassSettings *settings) {
    static CopyLab labs[COURSE_MAX_LABS];
    Jail jail = {0};
    const Jail *chosen = NULL;
    *copies = (Copies){.count = 0};
    bool ok = jail_choose(&jail, settings->route, false, "grade", &chosen);
    for (int n = 0; n < table->plan->lab_count; n++)
        ok = ok && open_lab(&labs[n], table->plan->labs[n], table->roster->count);
    for (int i = 0; ok && i < table->roster->count; i++)
        read_hand_in(table, i, chosen, labs);
    for (int n = 0; ok && n < table->plan->lab_count; n++)
        find_in_lab(copies, &labs[n], n, table->roster->count);
    for (int n = 0; n < table->plan->lab_count; n++)
        close_lab(&labs[n], table->roster->count);
    jail_destroy(&jail);
    return ok;
}

void copies_destroy(Copies *copies) {
    free(copies->pairs);
    *copies = (Copies){.count = 0};
}
