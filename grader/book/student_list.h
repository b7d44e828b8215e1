// Who takes the course: the list that a learning system or an office exports as CSV.
#pragma once

#include "base/csv.h"
#include "book/name_key.h"

#include <stdbool.h>
#include <time.h>

// What a list may tell of a student. student_list.c says under which heads.
typedef enum StudentField {
    STUDENT_ID,
    STUDENT_SIS, // the number that the office's system gives, where the learning system has another one
    STUDENT_LOGIN,
    STUDENT_MAIL,
    STUDENT_NAME, // the whole; made of the next two where the list has only those
    STUDENT_FIRST,
    STUDENT_LAST,
    STUDENT_SECTION,
    STUDENT_TIME, // when the work was handed in
    STUDENT_FIELDS
} StudentField;

typedef struct Student {
    int row;                      // of the CSV
    char *fields[STUDENT_FIELDS]; // as text (printable_name); "" for what the list does not tell
    char words[NAME_KEY];         // keys of the name
    char joined[2][NAME_KEY];     // last name first, and as it is
    time_t handed_in;             // 0: the list does not tell
} Student;

typedef struct StudentList {
    Csv csv;
    Student *students;
    int count;
} StudentList;

// Reads the list. Rows of "Points Possible" and of Canvas's test student are passed over. False with a
// message: there is no column that tells who it is, a row names nobody, or a number, login, mail or name
// stands there twice.
bool student_list_read(StudentList *list, const char *path);
void student_list_destroy(StudentList *list); // accepts a zeroed list

enum { STUDENT_NOBODY = -1, STUDENT_SEVERAL = -2 };

// Whose is a hand-in that gives this id ("" for none) and name? First by number, login or mail (also without
// what follows the @; letters' case and zeros in front do not count), then by the name. The student's number
// in the list, or one of the two above.
int student_list_find(const StudentList *list, const char *id, const char *name);

// What names the student best: the first of the fields up to the name that is not empty.
const char *student_key(const Student *student);
