// Writes what each learning system wants to know, from the list of students and the points that count.
#include "book/export_csv.h"

#include "base/csv_write.h"
#include "class/submission_record.h"
#include "intake/lab_name.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct ExportFile {
    const Book *book;
    const char *folder, *name;
    char *text;
    size_t size;
    FILE *out;
} ExportFile;

static ExportFile begin(const Book *book, const char *folder, const char *name) {
    return (ExportFile){.book = book, .folder = folder, .name = name};
}

static void open_text(ExportFile *file) {
    file->out = open_memstream(&file->text, &file->size);
    INVARIANT(file->out);
}

static bool end(ExportFile *file) {
    char path[FILES_PATH];
    fclose(file->out);
    files_join(path, file->folder, file->name);
    const bool ok = files_write_whole(path, file->text, true);
    free(file->text);
    return ok;
}

static void cell(ExportFile *file, const char *text) {
    csv_write_cell(file->out, text);
    fputc(',', file->out);
}

static const char *field(const ExportFile *file, const BookRow *row, StudentField which) {
    const Student *student = book_student(file->book, row);
    return student ? student->fields[which] : "";
}

static const char *hand_in_id(const ExportFile *file, const BookRow *row) {
    return row->entry >= 0 ? file->book->table->roster->entries[row->entry].id : "";
}

static const char *first_of(const char *a, const char *b) {
    return a[0] ? a : b;
}

// The title of a lab, as any record has it.
static const char *title(const Book *book, int n) {
    for (int r = 0; r < book->count; r++)
        if (book->rows[r].marks[n].measured)
            return table_text(table_lab(book->table, book->rows[r].entry, n), "name");
    return "";
}

// The most points of a lab; 0 when nobody has any.
static double most_points(const Book *book, int n) {
    for (int r = 0; r < book->count; r++)
        if (book->rows[r].marks[n].measured)
            return book->rows[r].marks[n].maximum;
    return 0;
}

// A column of the list that is this lab's: an assignment that is there already keeps its name.
static const char *listed_head(const Book *book, int n) {
    char id[3];
    for (int c = 0; book->listed && c < book->list.csv.column_count; c++)
        if (lab_name_find(id, book->list.csv.heads[c]) && strcmp(id, book->table->plan->labs[n]) == 0)
            return book->list.csv.heads[c];
    return NULL;
}

static void lab_head(ExportFile *file, int n, const char *more) {
    char head[300];
    const char *listed = listed_head(file->book, n);
    if (listed)
        snprintf(head, sizeof head, "%.200s%s", listed, more);
    else
        snprintf(head, sizeof head, "Lab %s: %.200s%s", file->book->table->plan->labs[n],
                 title(file->book, n), more);
    cell(file, head);
}

static void points(ExportFile *file, const BookRow *row, int n) {
    if (row->marks[n].known)
        fprintf(file->out, "%.2f", row->marks[n].points);
    fputc(',', file->out);
}

// Ends a row, in which each cell has ended with a comma.
static void end_row(ExportFile *file) {
    fseek(file->out, -1, SEEK_CUR);
    fputc('\n', file->out);
}

// Canvas knows students by a number of its own, and by that of the office: a list that is not its own has
// only the latter.
static bool is_of_canvas(const Book *book) {
    return !book->listed ||
           csv_column(&book->list.csv, (const char *const[]){"sis user id", "sis login id", NULL}) >= 0;
}

static void canvas_student(ExportFile *file, const BookRow *row) {
    const bool own = is_of_canvas(file->book);
    const char *last = field(file, row, STUDENT_LAST), *listed = "";
    char name[400];
    if (row->student >= 0) {
        const Csv *csv = &file->book->list.csv;
        listed = csv_cell(csv, file->book->list.students[row->student].row,
                          csv_column(csv, (const char *const[]){"student", NULL}));
    }
    snprintf(name, sizeof name, "%.190s, %.190s", last, field(file, row, STUDENT_FIRST));
    cell(file, last[0] ? name : first_of(listed, book_name(file->book, row)));
    cell(file, own ? first_of(field(file, row, STUDENT_ID), hand_in_id(file, row)) : hand_in_id(file, row));
    cell(file, first_of(field(file, row, STUDENT_SIS), own ? "" : field(file, row, STUDENT_ID)));
    cell(file, first_of(field(file, row, STUDENT_LOGIN), field(file, row, STUDENT_MAIL)));
    cell(file, field(file, row, STUDENT_SECTION));
}

bool export_canvas(const Book *book, const char *folder) {
    const int labs = book->table->plan->lab_count;
    ExportFile file = begin(book, folder, "canvas.csv");
    open_text(&file);
    fputs("Student,ID,SIS User ID,SIS Login ID,Section,", file.out);
    for (int n = 0; n < labs; n++)
        lab_head(&file, n, "");
    end_row(&file);
    fputs("    Points Possible,,,,,", file.out);
    for (int n = 0; n < labs; n++)
        fprintf(file.out, "%.2f,", most_points(book, n));
    end_row(&file);
    for (const BookRow *row = book->rows; row < book->rows + book->count; row++) {
        if (!book_counts(book, row))
            continue;
        canvas_student(&file, row);
        for (int n = 0; n < labs; n++)
            points(&file, row, n);
        end_row(&file);
    }
    return end(&file);
}

// The grading worksheet as Moodle gave it, with the grade filled in: the total, where there are points.
static bool write_worksheet(const Book *book, const char *folder, int grade) {
    const Csv *csv = &book->list.csv;
    ExportFile file = begin(book, folder, "moodle-worksheet.csv");
    open_text(&file);
    for (int c = 0; c < csv->column_count; c++)
        cell(&file, csv->heads[c]);
    end_row(&file);
    for (const BookRow *row = book->rows; row < book->rows + book->count; row++) {
        if (!book_counts(book, row))
            continue;
        for (int c = 0; c < csv->column_count; c++)
            if (c == grade && book_has_points(book, row))
                fprintf(file.out, "%.2f,", row->total);
            else
                cell(&file, csv_cell(csv, book->list.students[row->student].row, c));
        end_row(&file);
    }
    return end(&file);
}

bool export_moodle(const Book *book, const char *folder) {
    ExportFile file = begin(book, folder, "moodle.csv");
    open_text(&file);
    fputs("Full name,ID number,Email address,", file.out);
    for (int n = 0; n < book->table->plan->lab_count; n++)
        lab_head(&file, n, "");
    end_row(&file);
    for (const BookRow *row = book->rows; row < book->rows + book->count; row++) {
        if (!book_counts(book, row))
            continue;
        cell(&file, book_name(book, row));
        cell(&file, first_of(field(&file, row, STUDENT_ID), hand_in_id(&file, row)));
        cell(&file, field(&file, row, STUDENT_MAIL));
        for (int n = 0; n < book->table->plan->lab_count; n++)
            points(&file, row, n);
        end_row(&file);
    }
    if (!end(&file))
        return false;
    const int grade =
        book->listed ? csv_column(&book->list.csv, (const char *const[]){"grade", NULL}) : BOOK_NONE;
    const bool sheet =
        grade >= 0 && csv_column(&book->list.csv, (const char *const[]){"identifier", NULL}) >= 0;
    return !sheet || write_worksheet(book, folder, grade);
}

static void write_lateness(ExportFile *file, double seconds) {
    const long whole = (long)seconds;
    fprintf(file->out, "%02ld:%02ld:%02ld,", whole / 3600, whole / 60 % 60, whole % 60);
}

static double write_lab_times(ExportFile *file, const BookRow *row, int n) {
    const BookMark *mark = &row->marks[n];
    char text[BOOK_TIME_TEXT];
    BookClock clock;
    const time_t time = book_time(file->book, row, &clock);
    book_time_text(text, mark->handed_in ? time : 0);
    const double late =
        mark->handed_in ? late_rule_seconds(&file->book->late, file->book->table->plan->labs[n], time) : 0;
    points(file, row, n);
    fprintf(file->out, "%.2f,%s,", most_points(file->book, n), text);
    write_lateness(file, late);
    return late;
}

static void gradescope_names(ExportFile *file, const BookRow *row) {
    const char *name = book_name(file->book, row), *space = strrchr(name, ' ');
    char first[300];
    snprintf(first, sizeof first, "%.*s", space ? (int)(space - name) : (int)strlen(name), name);
    const bool known = field(file, row, STUDENT_LAST)[0] || field(file, row, STUDENT_FIRST)[0];
    cell(file, known ? field(file, row, STUDENT_FIRST) : first);
    cell(file, known ? field(file, row, STUDENT_LAST) : space ? space + 1 : "");
}

bool export_gradescope(const Book *book, const char *folder) {
    static const char *const heads[] = {"", " - Max Points", " - Submission Time", " - Lateness (H:M:S)"};
    const int labs = book->table->plan->lab_count;
    ExportFile file = begin(book, folder, "gradescope.csv");
    open_text(&file);
    fputs("First Name,Last Name,SID,Email,Sections,", file.out);
    for (int n = 0; n < labs; n++)
        for (int h = 0; h < 4; h++)
            lab_head(&file, n, heads[h]);
    fputs("Total Lateness (H:M:S)\n", file.out);
    for (const BookRow *row = book->rows; row < book->rows + book->count; row++) {
        double late = 0;
        if (!book_counts(book, row))
            continue;
        gradescope_names(&file, row);
        cell(&file, first_of(field(&file, row, STUDENT_ID), hand_in_id(&file, row)));
        cell(&file, field(&file, row, STUDENT_MAIL));
        cell(&file, field(&file, row, STUDENT_SECTION));
        for (int n = 0; n < labs; n++)
            late += write_lab_times(&file, row, n);
        write_lateness(&file, late);
        end_row(&file);
    }
    return end(&file);
}
