#include "class/table.h"

#include "scene/check.h"
#include "class/submission_record.h"

#include <stdlib.h>
#include <string.h>

static const char *grader_of(const Table *table, int i) {
    return table_text(json_object_get(table->records[i], "made_of"), "grader");
}

static bool has_one_grader(const Table *table) {
    const char *first = NULL;
    for (int i = 0; i < table->roster->count; i++) {
        if (!table_is_graded(table, i))
            continue;
        first = first ? first : grader_of(table, i);
        if (strcmp(first, grader_of(table, i)) != 0)
            return false;
    }
    return true;
}

static void find_stale(Table *table, const Origin *origin) {
    const bool one_grader = has_one_grader(table);
    for (int i = 0; i < table->roster->count; i++) {
        if (table_is_graded(table, i))
            origin_differs(table->stale[i], table->records[i], origin, table->plan, NULL);
        if (one_grader && strcmp(table->stale[i], ORIGIN_GRADER) == 0)
            table->stale[i][0] = '\0';
    }
}

void table_read(Table *table, const char *output, const Roster *roster, const RunSettings *plan,
                const Origin *origin) {
    const size_t count = (size_t)roster->count;
    *table =
        (Table){roster, plan, origin, calloc(count, sizeof(json_t *)), calloc(count, sizeof *table->stale)};
    INVARIANT(table->records && table->stale);
    for (int i = 0; output && i < roster->count; i++)
        table->records[i] = submission_record_read(output, &roster->entries[i]);
    find_stale(table, origin);
}

void table_free(Table *table) {
    for (int i = 0; table->records && i < table->roster->count; i++)
        json_decref(table->records[i]);
    free(table->records);
    free(table->stale);
    *table = (Table){0};
}

bool table_is_graded(const Table *table, int i) {
    return submission_record_is_graded(table->records[i]);
}

const char *table_reason(const Table *table, int i) {
    return table->records[i] ? table_text(table->records[i], "reason") : "not begun";
}

const json_t *table_lab(const Table *table, int i, int n) {
    size_t k;
    json_t *lab;
    json_array_foreach(json_object_get(json_object_get(table->records[i], "report"), "labs"), k, lab) {
        if (strcmp(table_text(lab, "id"), table->plan->labs[n]) == 0)
            return lab;
    }
    return NULL;
}

double table_number(const json_t *object, const char *key) {
    return json_number_value(json_object_get(object, key));
}

const char *table_text(const json_t *object, const char *key) {
    const char *text = json_string_value(json_object_get(object, key));
    return text ? text : "";
}

const char *table_status(const Table *table, int i) {
    if (!table_is_graded(table, i))
        return "not graded";
    for (int n = 0; n < table->plan->lab_count; n++)
        if (strcmp(table_text(table_lab(table, i, n), "status"), "passed") != 0)
            return "failed";
    return "passed";
}

double table_total(const Table *table, int i) {
    double total = 0;
    for (int n = 0; n < table->plan->lab_count; n++)
        total += table_number(table_lab(table, i, n), "score");
    return total;
}
