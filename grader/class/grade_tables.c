#include "class/grade_tables.h"

#include "scene/check.h"
#include "scene/count.h"
#include "class/index.h"
#include "class/table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Does a spreadsheet take a cell that begins so for a formula? A quote, which tells it not to, is doubled in
// effect.
static bool is_dangerous(const char *text) {
    static const char *const begins[] = {"=", "+", "-", "@", "'", "\uff1d", "\uff0b", "\uff0d", "\uff20"};
    for (size_t i = 0; i < COUNT(begins); i++)
        if (strncmp(text, begins[i], strlen(begins[i])) == 0)
            return true;
    return false;
}

// The first line of the text.
static void write_name(FILE *out, const char *text) {
    fputs(is_dangerous(text) ? "\"'" : "\"", out);
    for (; *text && *text != '\n'; text++)
        fputs(*text == '"' ? "\"\"" : (char[2]){*text, '\0'}, out);
    fputc('"', out);
}

// Why there is no grade, or the first thing that kept a lab from being drawn.
static const char *reason(const Table *table, int i) {
    if (!table_is_graded(table, i))
        return table_reason(table, i);
    for (int n = 0; n < table->plan->lab_count; n++)
        if (table_text(table_lab(table, i, n), "message")[0])
            return table_text(table_lab(table, i, n), "message");
    return "";
}

static void write_row(FILE *out, const Table *table, int i) {
    bool graded = table_is_graded(table, i);
    write_name(out, table->roster->entries[i].shown);
    for (int n = 0; n < table->plan->lab_count; n++)
        if (graded)
            fprintf(out, ",%.2f", table_number(table_lab(table, i, n), "score"));
        else
            fputc(',', out);
    if (graded)
        fprintf(out, ",%.2f,%s,", table_total(table, i), table_status(table, i));
    else
        fprintf(out, ",,%s,", table_status(table, i));
    write_name(out, table->roster->entries[i].student);
    fputc(',', out);
    write_name(out, table->roster->entries[i].id);
    fputs(table->roster->entries[i].late ? ",late," : ",,", out);
    write_name(out, reason(table, i));
    fputc('\n', out);
}

static bool write_csv(const char *output, const Table *table) {
    char path[FILES_PATH], *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    INVARIANT(out);
    fputs("submission", out);
    for (int n = 0; n < table->plan->lab_count; n++)
        fprintf(out, ",lab %s", table->plan->labs[n]);
    fputs(",total,status,student,id,late,reason\n", out);
    for (int i = 0; i < table->roster->count; i++)
        write_row(out, table, i);
    bool whole = fclose(out) == 0;
    INVARIANT(whole);
    files_join(path, output, "grades.csv");
    bool ok = files_write_whole(path, text, true);
    free(text);
    return ok;
}

static bool write_index(const char *output, const Table *table) {
    char path[FILES_PATH];
    char *page = index_page(table);
    files_join(path, output, "index.html");
    bool ok = page && files_write_whole(path, page, true);
    free(page);
    return ok;
}

bool grade_tables_write(const char *output, const Roster *roster, const RunSettings *plan, int *not_graded) {
    Table table;
    table_read(&table, output, roster, plan);
    *not_graded = 0;
    for (int i = 0; i < roster->count; i++)
        *not_graded += !table_is_graded(&table, i);
    bool ok = write_csv(output, &table) && write_index(output, &table);
    table_free(&table);
    return ok;
}
