// What the name of a hand-in tells, as learning systems write it when a class is downloaded.
#pragma once

#include <stdbool.h>
#include <time.h>

enum { HAND_IN_TEXT = 256 };

typedef struct HandInName {
    char student[HAND_IN_TEXT]; // never empty
    char id[HAND_IN_TEXT];      // the system's number or login of the student; "" when the name has none
    char attempt[HAND_IN_TEXT]; // of two attempts of one form the larger is the newer (hand_in_compare); may
                                // be ""
    char file[HAND_IN_TEXT];    // the name that the student gave the file; "" when the name does not hold it
    bool late;
    time_t time; // when it was handed in; 0: the name does not tell
} HandInName;

// Is it one student, by the id where there is one ("": none), else by the name?
bool hand_in_same_student(const char *id, const char *student, const char *other_id,
                          const char *other_student);

// The forms, tried in this order: Moodle "Full Name_ID_assignsubmission_file_", Blackboard
// "..._LOGIN_attempt_DATE_file", Canvas "lastfirst_LATE_ID_FILEID_file", Gradescope "submission_ID",
// Brightspace "NUMBER-NUMBER - Full Name - date"; else the name itself, without the ending of an archive and
// without the
// "(2)" of a second download. `name` may be any bytes.
void hand_in_name_read(HandInName *hand_in, const char *name);

// Classroom repositories: all names begin with the same "lab-03-". Its length if it tells a lab, else 0.
int hand_in_prefix(const char *const *names, int count);

// Which attempt is the newer, by the number or date in the name? Above 0: a; 0: the names do not tell.
int hand_in_compare(const HandInName *a, const HandInName *b);
