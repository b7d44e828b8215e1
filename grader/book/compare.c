// Reads the records of two outputs, pairs them by the names of the submissions, and prints what is different.
#include "book/compare.h"

#include "base/csv_write.h"
#include "base/files.h"
#include "class/table.h"
#include "scene/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double noise = 0.005; // points are hundredths

typedef struct RecordList {
    char folder[FILES_PATH];
    json_t **records;
    int count;
} RecordList;

typedef struct Comparison {
    FILE *out, *csv; // csv: NULL for none
    const char *name;
    bool named; // the submission's line was printed
    json_t *old, *new;
    int both, up, down, only_old, only_new;
    double sum_old, sum_new;
} Comparison;

static void add_record(const char *name, void *context) {
    RecordList *list = context;
    char path[FILES_PATH];
    const char *dot = strrchr(name, '.');
    if (name[0] == '.' || !dot || strcmp(dot, ".json") != 0)
        return;
    files_join(path, list->folder, name);
    json_t *record = json_load_file(path, 0, NULL);
    if (!json_is_string(json_object_get(record, "submission"))) {
        json_decref(record);
        return;
    }
    if ((list->count & (list->count - 1)) == 0) { // room is always a power of two
        list->records =
            realloc(list->records, sizeof(json_t *) * (size_t)(list->count ? 2 * list->count : 1));
        INVARIANT(list->records);
    }
    list->records[list->count++] = record;
}

static int by_name(const void *a, const void *b) {
    return strcmp(table_text(*(json_t *const *)a, "submission"),
                  table_text(*(json_t *const *)b, "submission"));
}

static bool read_records(RecordList *list, const char *output) {
    *list = (RecordList){.count = 0};
    if (strlen(output) > FILES_PATH - 300)
        return check_fail("%.100s...: the path is too long", output);
    files_join(list->folder, output, "results");
    if (!files_is_folder(list->folder) || !files_list(list->folder, add_record, list) || list->count == 0) {
        check_clear();
        return check_fail("%s holds no results of a class run: give the folder that was its --output",
                          output);
    }
    qsort(list->records, (size_t)list->count, sizeof(json_t *), by_name);
    return true;
}

static void free_records(RecordList *list) {
    for (int i = 0; i < list->count; i++)
        json_decref(list->records[i]);
    free(list->records);
}

static void write_csv(Comparison *comparison, const char *lab, const char *check, double old, double new) {
    if (!comparison->csv)
        return;
    csv_write_cell(comparison->csv, comparison->name);
    fprintf(comparison->csv, ",%s,", lab);
    csv_write_cell(comparison->csv, check);
    fprintf(comparison->csv, ",%.2f,%.2f,%.2f\n", old, new, new - old);
}

static void name_once(Comparison *comparison) {
    if (!comparison->named)
        fprintf(comparison->out, "%s\n", comparison->name);
    comparison->named = true;
}

// The entry of the list whose text at `key` is `text`; NULL when there is none.
static const json_t *entry_of(const json_t *list, const char *key, const char *text) {
    size_t i;
    const json_t *entry;
    json_array_foreach(list, i, entry) if (strcmp(table_text(entry, key), text) == 0) return entry;
    return NULL;
}

static void compare_check(Comparison *comparison, const char *lab, const json_t *old, const json_t *new) {
    const char *name = table_text(new ? new : old, "name");
    const double before = table_number(old, "score"), after = table_number(new, "score");
    if (fabs(after - before) < noise && (old != NULL) == (new != NULL))
        return;
    name_once(comparison);
    fprintf(comparison->out, "    lab %s, %s: %.2f -> %.2f%s\n", lab, name, before, after,
            !old   ? " (a new check)"
            : !new ? " (no check any more)"
                   : "");
    write_csv(comparison, lab, name, before, after);
}

static void compare_lab(Comparison *comparison, const json_t *old, const json_t *new) {
    size_t i;
    const json_t *check, *before = json_object_get(old, "checks"), *after = json_object_get(new, "checks");
    const char *lab = table_text(new ? new : old, "id");
    if (!old || !new) {
        name_once(comparison);
        fprintf(comparison->out, "    lab %s: only in the %s\n", lab, old ? "first" : "second");
        return;
    }
    json_array_foreach(after, i, check)
        compare_check(comparison, lab, entry_of(before, "name", table_text(check, "name")), check);
    json_array_foreach(before, i, check) if (!entry_of(after, "name", table_text(check, "name")))
        compare_check(comparison, lab, check, NULL);
    if (fabs(table_number(new, "score") - table_number(old, "score")) >= noise)
        write_csv(comparison, lab, "", table_number(old, "score"), table_number(new, "score"));
}

static const json_t *labs_of(const json_t *record) {
    return json_object_get(json_object_get(record, "report"), "labs");
}

static void compare_reports(Comparison *comparison) {
    size_t i;
    const json_t *lab, *before = labs_of(comparison->old), *after = labs_of(comparison->new);
    const double old = table_number(json_object_get(comparison->old, "report"), "score");
    const double new = table_number(json_object_get(comparison->new, "report"), "score");
    comparison->both++;
    comparison->sum_old += old;
    comparison->sum_new += new;
    comparison->up += new - old >= noise;
    comparison->down += old - new >= noise;
    if (fabs(new - old) >= noise) {
        fprintf(comparison->out, "%s: %.2f -> %.2f (%+.2f)\n", comparison->name, old, new, new - old);
        comparison->named = true;
    }
    json_array_foreach(after, i, lab)
        compare_lab(comparison, entry_of(before, "id", table_text(lab, "id")), lab);
    json_array_foreach(before, i, lab) if (!entry_of(after, "id", table_text(lab, "id")))
        compare_lab(comparison, lab, NULL);
}

// A submission of the first, the second, or both.
static void compare_pair(Comparison *comparison, json_t *old, json_t *new) {
    const bool was = json_is_true(json_object_get(old, "graded")),
               is = json_is_true(json_object_get(new, "graded"));
    comparison->name = table_text(new ? new : old, "submission");
    comparison->named = false;
    comparison->old = old;
    comparison->new = new;
    comparison->only_old += was && !is;
    comparison->only_new += is && !was;
    if (was && is)
        compare_reports(comparison);
    else if (was || is)
        fprintf(comparison->out, "%s: %s only in the %s\n", comparison->name,
                old && new ? "graded" : "is there", was ? "first" : "second");
}

static void compare_lists(Comparison *comparison, const RecordList *old, const RecordList *new) {
    for (int i = 0, j = 0; i < old->count || j < new->count;) {
        const int order = i == old->count   ? 1
                          : j == new->count ? -1
                                            : by_name(&old->records[i], &new->records[j]);
        compare_pair(comparison, order <= 0 ? old->records[i] : NULL, order >= 0 ? new->records[j] : NULL);
        i += order <= 0;
        j += order >= 0;
    }
}

static void say_sums(const Comparison *comparison) {
    fprintf(comparison->out, "%d graded in both: %d have more points, %d fewer", comparison->both,
            comparison->up, comparison->down);
    if (comparison->both > 0)
        fprintf(comparison->out, "; the mean was %.2f and is %.2f", comparison->sum_old / comparison->both,
                comparison->sum_new / comparison->both);
    fprintf(comparison->out, "\n%d graded only in the first, %d only in the second\n", comparison->only_old,
            comparison->only_new);
}

static bool write_changes(const char *folder, const char *text) {
    char path[FILES_PATH];
    files_join(path, folder, "changes.csv");
    return files_make_folder(folder) && files_write_whole(path, text, true);
}

bool compare_outputs(const char *old_folder, const char *new_folder, const char *csv_folder, FILE *out) {
    RecordList old = {0}, new = {0};
    char *text = NULL;
    size_t size;
    Comparison comparison = {.out = out, .csv = csv_folder ? open_memstream(&text, &size) : NULL};
    bool ok = read_records(&old, old_folder) && read_records(&new, new_folder);
    if (comparison.csv)
        fputs("submission,lab,check,old,new,change\n", comparison.csv);
    if (ok) {
        compare_lists(&comparison, &old, &new);
        say_sums(&comparison);
    }
    if (comparison.csv) {
        fclose(comparison.csv);
        ok = ok && write_changes(csv_folder, text);
    }
    free(text);
    free_records(&old);
    free_records(&new);
    return ok;
}
