// Writes the rows as SQL, and lets sqlite3 make the file of it.
#include "book/export_sqlite.h"

#include "base/process.h"
#include "scene/check.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_SECONDS = 120 };
static const char script[] = ".new-grades.sql", made[] = ".new-grades.sqlite";

static const char schema[] =
    "PRAGMA journal_mode = OFF;\nBEGIN;\n"
    "CREATE TABLE student (student INTEGER PRIMARY KEY, id TEXT, name TEXT, mail TEXT, section TEXT,\n"
    "    submission TEXT, status TEXT NOT NULL, total REAL, note TEXT, time TEXT, time_by TEXT);\n"
    "CREATE TABLE lab (lab TEXT PRIMARY KEY);\n"
    "CREATE TABLE grade (student INTEGER NOT NULL REFERENCES student, lab TEXT NOT NULL REFERENCES lab,\n"
    "    handed_in INTEGER NOT NULL, points REAL, measured REAL, maximum REAL, late_days INTEGER NOT NULL,\n"
    "    free_days INTEGER NOT NULL, taken REAL NOT NULL, PRIMARY KEY (student, lab));\n"
    "CREATE TABLE \"check\" (student INTEGER NOT NULL REFERENCES student, lab TEXT NOT NULL REFERENCES lab,\n"
    "    task TEXT NOT NULL, name TEXT NOT NULL, points REAL NOT NULL, maximum REAL NOT NULL,\n"
    "    passed INTEGER NOT NULL, mistake TEXT, PRIMARY KEY (student, lab, name));\n";

// A text as SQL, on one line.
static void write_text(FILE *out, const char *text) {
    fputc('\'', out);
    for (; *text; text++)
        fputs(*text == '\'' ? "''" : *text == '\n' || *text == '\r' ? " " : (char[2]){*text, '\0'}, out);
    fputc('\'', out);
}

static void write_next(FILE *out, const char *text) {
    fputc(',', out);
    write_text(out, text);
}

static void write_student(FILE *out, const Book *book, const BookRow *row, long number) {
    const Student *student = book_student(book, row);
    char time[BOOK_TIME_TEXT];
    BookClock clock;
    book_time_text(time, book_time(book, row, &clock));
    fprintf(out, "INSERT INTO student VALUES(%ld", number);
    write_next(out, book_id(book, row));
    write_next(out, book_name(book, row));
    write_next(out, student ? student->fields[STUDENT_MAIL] : "");
    write_next(out, student ? student->fields[STUDENT_SECTION] : "");
    write_next(out, row->entry >= 0 ? book->table->roster->entries[row->entry].shown : "");
    write_next(out, book_status(book, row));
    if (book_has_points(book, row))
        fprintf(out, ",%.2f", row->total);
    else
        fputs(",NULL", out);
    write_next(out, row->note ? row->note : "");
    write_next(out, time);
    write_next(out, book_clock_name(clock));
    fputs(");\n", out);
}

// A lab's predictions as one more row, so that its rows sum up to its points.
static void write_predictions(FILE *out, const json_t *lab, long number, const char *id) {
    size_t i;
    const json_t *result;
    double score = 0, most = 0;
    json_array_foreach(json_object_get(json_object_get(lab, "predictions"), "results"), i, result) {
        score += table_number(result, "score");
        most += table_number(result, "max_score");
    }
    if (most > 0)
        fprintf(out, "INSERT INTO \"check\" VALUES(%ld,'%s','%d','predictions',%.2f,%.2f,%d,'');\n", number,
                id, atoi(id), score, most, score == most);
}

static void write_checks(FILE *out, const json_t *lab, long number, const char *id) {
    size_t i;
    const json_t *check;
    json_array_foreach(json_object_get(lab, "checks"), i, check) {
        fprintf(out, "INSERT INTO \"check\" VALUES(%ld,'%s'", number, id);
        write_next(out, table_text(check, "task"));
        write_next(out, table_text(check, "name"));
        fprintf(out, ",%.2f,%.2f,%d", table_number(check, "score"), table_number(check, "max_score"),
                json_is_true(json_object_get(check, "passed")));
        write_next(out, table_text(json_object_get(check, "cause"), "kind"));
        fputs(");\n", out);
    }
    write_predictions(out, lab, number, id);
}

static void write_grade(FILE *out, const BookMark *mark, long number, const char *lab) {
    fprintf(out, "INSERT INTO grade VALUES(%ld,'%s',%d,", number, lab, mark->handed_in);
    if (mark->known)
        fprintf(out, "%.2f,", mark->points);
    else
        fputs("NULL,", out);
    if (mark->measured)
        fprintf(out, "%.2f,%.2f,", mark->score, mark->maximum);
    else
        fputs("NULL,NULL,", out);
    fprintf(out, "%d,%d,%.2f);\n", mark->late_days, mark->free_days, mark->taken);
}

static char *to_sql(const Book *book) {
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    INVARIANT(out);
    fputs(schema, out);
    for (int n = 0; n < book->table->plan->lab_count; n++)
        fprintf(out, "INSERT INTO lab VALUES('%s');\n", book->table->plan->labs[n]);
    for (int r = 0; r < book->count; r++) {
        const BookRow *row = &book->rows[r];
        write_student(out, book, row, r + 1);
        for (int n = 0; n < book->table->plan->lab_count; n++) {
            const char *lab = book->table->plan->labs[n];
            write_grade(out, &row->marks[n], r + 1, lab);
            if (row->marks[n].handed_in)
                write_checks(out, table_lab(book->table, row->entry, n), r + 1, lab);
        }
    }
    fputs("COMMIT;\n", out);
    fclose(out);
    return text;
}

static bool run(const char *folder) {
    static Process process; // holds what was printed: too large for a stack
    char path[4096];
    snprintf(path, sizeof path, "PATH=%s", getenv("PATH") ? getenv("PATH") : "/usr/local/bin:/usr/bin:/bin");
    char *const arguments[] = {
        "sqlite3", "-batch", "-bail", "-init", "/dev/null", (char *)made, ".read .new-grades.sql", NULL};
    char *const environment[] = {path, "LC_ALL=C", "HOME=/nonexistent", NULL};
    const ProcessLimits limits = {.wall_seconds = MOST_SECONDS};
    if (!process_start(&process, arguments, environment, folder, &limits))
        return false;
    process_wait(&process);
    const bool ok =
        process.state == PROCESS_ENDED && WIFEXITED(process.status) && WEXITSTATUS(process.status) == 0;
    if (!ok)
        check_fail("sqlite3 could not write %s/grades.sqlite (is it installed? common/setup --test): %.300s",
                   folder, process.text);
    process_stop(&process);
    return ok;
}

bool export_sqlite(const Book *book, const char *folder) {
    char sql[FILES_PATH], from[FILES_PATH], to[FILES_PATH], *text = to_sql(book);
    files_join(sql, folder, script);
    files_join(from, folder, made);
    files_join(to, folder, "grades.sqlite");
    unlink(from);
    bool ok = files_write(sql, text) && run(folder);
    if (ok && rename(from, to) != 0)
        ok = check_fail("%s cannot be written: %s", to, strerror(errno));
    unlink(sql);
    unlink(from);
    free(text);
    return ok;
}
