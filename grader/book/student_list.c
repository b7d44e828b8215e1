// Finds the columns of a list by their heads, reads a student of each row, and finds the student of a
// hand-in.
#include "book/student_list.h"

#include "base/printable.h"
#include "book/plain_number.h"
#include "class/hand_in_time.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const char *const heads[STUDENT_FIELDS][24] = {
    [STUDENT_ID] = {"id", "student id", "sid", "id number", "student number", "identifier", "org defined id",
                    "user id", "matriculation number", "matrikelnummer", "number", "matr nr", "matrikel nr",
                    "id nummer", "numéro d’identification", "numéro d'étudiant", "número de id", "matricola",
                    "opiskelijanumero"},
    [STUDENT_SIS] = {"sis user id", "sis id"},
    [STUDENT_LOGIN] = {"sis login id", "login id", "login", "username", "user name", "user", "net id",
                       "github username", "account"},
    [STUDENT_MAIL] = {"email", "email address", "mail", "mail address", "e-mail-adresse",
                      "adresse de courriel", "courriel", "correo electrónico", "dirección de correo",
                      "indirizzo email", "sähköposti"},
    [STUDENT_NAME] = {"full name", "student name", "name", "student", "display name", "vollständiger name",
                      "nom complet", "nombre completo"},
    [STUDENT_FIRST] = {"first name", "given name", "given names", "forename", "first", "vorname", "prénom",
                       "nombre", "nome", "etunimi"},
    [STUDENT_LAST] = {"last name", "surname", "family name", "last", "nachname", "familienname",
                      "nom de famille", "nom", "apellidos", "apellido", "cognome", "sukunimi"},
    [STUDENT_SECTION] = {"section", "sections", "section name", "group", "tutorial", "gruppe"},
    [STUDENT_TIME] = {"submission time", "last modified (submission)", "handed in", "submitted"},
};
static const StudentField keys[] = {STUDENT_ID, STUDENT_SIS, STUDENT_LOGIN, STUDENT_MAIL, STUDENT_NAME};
enum { KEYS = sizeof keys / sizeof keys[0] };

// Moodle's worksheet writes "Participant 123", each in its language.
static const char *without_word(const char *text) {
    static const char *const words[] = {"Participant ", "Teilnehmer/in"};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (strncasecmp(text, words[i], strlen(words[i])) == 0)
            return text + strlen(words[i]);
    return text;
}

// "Lee, Ann" is "Ann Lee".
static char *in_order(const char *last_first) {
    const char *comma = strchr(last_first, ',');
    char *name;
    if (!comma)
        return strdup(last_first);
    const int length =
        asprintf(&name, "%s %.*s", comma + 1 + strspn(comma + 1, " "), (int)(comma - last_first), last_first);
    return length < 0 ? NULL : name;
}

static char *whole_name(const Student *student) {
    char *const *fields = student->fields;
    char *name = NULL;
    if (fields[STUDENT_NAME][0])
        return in_order(fields[STUDENT_NAME]);
    const bool both = fields[STUDENT_FIRST][0] && fields[STUDENT_LAST][0];
    const int length =
        asprintf(&name, "%s%s%s", fields[STUDENT_FIRST], both ? " " : "", fields[STUDENT_LAST]);
    return length < 0 ? NULL : name;
}

// Beside a column of first names one of names has the last ones, unless it has both.
static void tell_apart(Student *student) {
    char **name = &student->fields[STUDENT_NAME], **last = &student->fields[STUDENT_LAST], *of_name = *name;
    const char *first = student->fields[STUDENT_FIRST];
    if (!first[0] || (*last)[0] || strchr(of_name, ',') || strcasestr(of_name, first))
        return;
    *name = *last;
    *last = of_name;
}

static void make_keys(Student *student) {
    const char *name = student->fields[STUDENT_NAME], *last = student->fields[STUDENT_LAST];
    const char *first = student->fields[STUDENT_FIRST], *space = strrchr(name, ' ');
    char before[NAME_KEY];
    snprintf(before, sizeof before, "%.*s", space ? (int)(space - name) : 0, name);
    name_key_words(student->words, name);
    name_key_joined(student->joined[0], last[0] ? last : space ? space : name, last[0] ? first : before);
    name_key_joined(student->joined[1], name, "");
}

static bool read_time(const Csv *csv, Student *student) {
    const char *text = student->fields[STUDENT_TIME];
    return strcmp(text, "") == 0 || strcmp(text, "-") == 0 || hand_in_time_parse(&student->handed_in, text) ||
           csv_fail(csv, student->row, "\"%.60s\" is no time: write 2026-11-03 23:59", text);
}

static bool is_no_student(const Csv *csv, int row, const int columns[STUDENT_FIELDS]) {
    const char *name = csv_cell(csv, row, columns[STUDENT_NAME]);
    return strcmp(name, "Points Possible") == 0 || strcmp(name, "Student, Test") == 0;
}

// All fields are strings afterwards, whatever is wrong.
static bool read_field(Student *student, int field, const Csv *csv, int column) {
    const char *cell = without_word(csv_cell(csv, student->row, column));
    char number[200];
    if (field > STUDENT_LOGIN || strlen(cell) >= sizeof number) {
        student->fields[field] = printable_name(cell);
        return true;
    }
    const bool whole = plain_number(number, sizeof number, cell);
    student->fields[field] = printable_name(number);
    return whole ||
           csv_fail(csv, student->row,
                    "\"%.60s\" is what a spreadsheet has left of a number: format its column as text "
                    "and export the list again",
                    cell);
}

static bool read_student(StudentList *list, int row, const int columns[STUDENT_FIELDS]) {
    Student *student = &list->students[list->count++];
    student->row = row;
    bool plain = true;
    for (int f = 0; f < STUDENT_FIELDS; f++)
        plain = read_field(student, f, &list->csv, columns[f]) && plain;
    if (!plain)
        return false;
    tell_apart(student);
    char *name = whole_name(student);
    INVARIANT(name);
    free(student->fields[STUDENT_NAME]);
    student->fields[STUDENT_NAME] = name;
    make_keys(student);
    return (student_key(student)[0] ||
            csv_fail(&list->csv, row, "the row names nobody: remove it, or write a number or a name")) &&
           read_time(&list->csv, student);
}

typedef struct Twice {
    const StudentList *list;
    StudentField field;
} Twice;

static int by_field(const void *a, const void *b, void *context) {
    const Twice *twice = context;
    const Student *students = twice->list->students;
    const int i = *(const int *)a, j = *(const int *)b;
    const int order = strcasecmp(students[i].fields[twice->field], students[j].fields[twice->field]);
    return order ? order : i - j;
}

// Two students may have one name where a number or a mail tells them apart.
static bool may_repeat(const Student *student, StudentField field) {
    return !student->fields[field][0] ||
           (field == STUDENT_NAME && student_key(student) != student->fields[field]);
}

static bool stands_once(const StudentList *list, StudentField field) {
    Twice twice = {list, field};
    int *order = calloc((size_t)list->count + 1, sizeof *order);
    INVARIANT(order);
    bool ok = true;
    for (int i = 0; i < list->count; i++)
        order[i] = i;
    qsort_r(order, (size_t)list->count, sizeof *order, by_field, &twice);
    for (int i = 1; ok && i < list->count; i++) {
        const Student *first = &list->students[order[i - 1]], *second = &list->students[order[i]];
        if (!may_repeat(second, field) && strcasecmp(first->fields[field], second->fields[field]) == 0)
            ok = csv_fail(&list->csv, second->row, "\"%.60s\" stands already in line %d: keep one of them",
                          second->fields[field], list->csv.rows[first->row].line);
    }
    free(order);
    return ok;
}

static bool read_all(StudentList *list, const int columns[STUDENT_FIELDS]) {
    list->students = calloc((size_t)list->csv.count + 1, sizeof *list->students);
    INVARIANT(list->students);
    for (int row = 0; row < list->csv.count; row++)
        if (!is_no_student(&list->csv, row, columns) && !read_student(list, row, columns))
            return false;
    for (int k = 0; k < KEYS; k++)
        if (!stands_once(list, keys[k]))
            return false;
    return list->count > 0 || csv_fail(&list->csv, -1, "below the heads there is no student");
}

bool student_list_read(StudentList *list, const char *path) {
    int columns[STUDENT_FIELDS];
    bool found = false, once = true;
    *list = (StudentList){0};
    if (!csv_read(&list->csv, path))
        return false;
    for (int f = 0; f < STUDENT_FIELDS; f++) {
        columns[f] = csv_column(&list->csv, heads[f]);
        once = once && csv_named_once(&list->csv, columns[f]);
        found = found || (f <= STUDENT_LAST && columns[f] >= 0);
    }
    if (once &&
        (found || csv_fail(&list->csv, -1,
                           "no column tells who the students are: name one of them id, login, "
                           "mail or name")) &&
        read_all(list, columns))
        return true;
    student_list_destroy(list);
    return false;
}

void student_list_destroy(StudentList *list) {
    for (int i = 0; i < list->count; i++)
        for (int f = 0; f < STUDENT_FIELDS; f++)
            free(list->students[i].fields[f]);
    free(list->students);
    csv_destroy(&list->csv);
    *list = (StudentList){0};
}

// Spreadsheets drop zeros in front of numbers.
static const char *without_zeros(const char *text) {
    const size_t zeros = strspn(text, "0");
    return text[zeros] && !text[strspn(text, "0123456789")] ? text + zeros : text;
}

static bool has_key(const Student *student, const char *key) {
    const char *mail = student->fields[STUDENT_MAIL], *at = strchr(mail, '@');
    for (int k = 0; k < KEYS && keys[k] != STUDENT_NAME; k++)
        if (student->fields[keys[k]][0] &&
            strcasecmp(without_zeros(student->fields[keys[k]]), without_zeros(key)) == 0)
            return true;
    return at && at > mail && strlen(key) == (size_t)(at - mail) && strncasecmp(mail, key, strlen(key)) == 0;
}

static bool has_name(const Student *student, const char words[NAME_KEY], const char joined[NAME_KEY]) {
    return words[0] && (strcmp(student->words, words) == 0 || strcmp(student->joined[0], joined) == 0 ||
                        strcmp(student->joined[1], joined) == 0);
}

// Of 7 and 007 the one counts that is written so.
static int find_written(const StudentList *list, const char *key) {
    for (int i = 0; key[0] && i < list->count; i++)
        for (int k = 0; k < KEYS && keys[k] != STUDENT_NAME; k++)
            if (strcmp(list->students[i].fields[keys[k]], key) == 0)
                return i;
    return STUDENT_SEVERAL;
}

static int find_key(const StudentList *list, const char *key) {
    int found = STUDENT_NOBODY;
    for (int i = 0; key[0] && i < list->count; i++)
        if (has_key(&list->students[i], key))
            found = found == STUDENT_NOBODY ? i : STUDENT_SEVERAL;
    return found == STUDENT_SEVERAL ? find_written(list, key) : found;
}

static int find_name(const StudentList *list, const char *name) {
    char words[NAME_KEY], joined[NAME_KEY];
    int found = STUDENT_NOBODY, exact = STUDENT_NOBODY;
    name_key_words(words, name);
    name_key_joined(joined, name, "");
    for (int i = 0; i < list->count; i++) {
        const Student *student = &list->students[i];
        if (strcmp(student->fields[STUDENT_NAME], name) == 0)
            exact = exact == STUDENT_NOBODY ? i : STUDENT_SEVERAL;
        if (has_name(student, words, joined))
            found = found == STUDENT_NOBODY ? i : STUDENT_SEVERAL;
    }
    return exact != STUDENT_NOBODY ? exact : found;
}

int student_list_find(const StudentList *list, const char *id, const char *name) {
    int found = find_key(list, id);
    if (found == STUDENT_NOBODY)
        found = find_key(list, name);
    return found == STUDENT_NOBODY ? find_name(list, name) : found;
}

const char *student_key(const Student *student) {
    int k = 0;
    while (k < KEYS - 1 && !student->fields[keys[k]][0])
        k++;
    return student->fields[keys[k]];
}
