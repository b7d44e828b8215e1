// Tries the forms of learning systems one after the other on a name.
#include "class/hand_in_name.h"

#include "scene/check.h"
#include "class/hand_in_time.h"
#include "intake/archive.h"
#include "intake/lab_name.h"
#include "scene/count.h"

#include <ctype.h>
#include <regex.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// A POSIX extended expression and which of its groups tell what; 0: none.
static const struct {
    const char *pattern;
    int student, id, attempt, late, file, time;
} forms[] = {
    {"^(.+)_([0-9]+)_assignsubmission_(file|onlinetext)_?(.*)$", 1, 2, 0, 0, 4, 0},
    {"^(.+_)?([^_]+)_attempt_([0-9]{4}(-[0-9]{2}){5})(_(.+))?$", 2, 2, 3, 0, 6, 3},
    {"^([[:alnum:]-]+)(_LATE)?_([0-9]+)_([0-9]+)_(.+)$", 1, 3, 4, 2, 5, 0},
    {"^submission_([0-9]+)$", 1, 1, 0, 0, 0, 0},
    {"^[0-9]+-[0-9]+ ?- (.+) - (.+)$", 1, 0, 0, 0, 0, 2},
};
enum { GROUPS = 8 };

static void take(char text[HAND_IN_TEXT], const char *name, const regmatch_t *match) {
    const int length = match->rm_so < 0 ? 0 : (int)(match->rm_eo - match->rm_so);
    snprintf(text, HAND_IN_TEXT, "%.*s", length, name + (length ? match->rm_so : 0));
}

static bool read_form(HandInName *hand_in, const char *name, size_t f) {
    regex_t form;
    regmatch_t groups[GROUPS] = {0};
    char date[HAND_IN_TEXT];
    int wrong = regcomp(&form, forms[f].pattern, REG_EXTENDED);
    INVARIANT(wrong == 0);
    const bool fits = regexec(&form, name, GROUPS, groups, 0) == 0;
    regfree(&form);
    if (!fits)
        return false;
    take(hand_in->student, name, &groups[forms[f].student]);
    if (forms[f].id)
        take(hand_in->id, name, &groups[forms[f].id]);
    if (forms[f].attempt)
        take(hand_in->attempt, name, &groups[forms[f].attempt]);
    if (forms[f].file)
        take(hand_in->file, name, &groups[forms[f].file]);
    if (forms[f].time) {
        take(date, name, &groups[forms[f].time]);
        if (!hand_in_time_parse(&hand_in->time, date))
            hand_in->time = 0;
    }
    hand_in->late = forms[f].late && groups[forms[f].late].rm_so >= 0;
    return true;
}

// "Ann Lee (2)" is the second download of "Ann Lee".
static void cut_number(HandInName *hand_in) {
    char *text = hand_in->student, *open = strrchr(text, '(');
    const size_t length = strlen(text);
    if (!open || open == text || text[length - 1] != ')' ||
        strspn(open + 1, "0123456789") != strlen(open) - 2 || open[1] == ')')
        return;
    snprintf(hand_in->attempt, sizeof hand_in->attempt, "%.*s", (int)strlen(open) - 2, open + 1);
    while (open > text + 1 && open[-1] == ' ')
        open--;
    *open = '\0';
}

void hand_in_name_read(HandInName *hand_in, const char *name) {
    memset(hand_in, 0, sizeof *hand_in);
    for (size_t f = 0; f < COUNT(forms); f++)
        if (read_form(hand_in, name, f))
            return;
    snprintf(hand_in->student, sizeof hand_in->student, "%.*s", (int)archive_stem(name), name);
    cut_number(hand_in);
}

int hand_in_prefix(const char *const *names, int count) {
    char id[3], prefix[HAND_IN_TEXT];
    if (count < 2)
        return 0;
    size_t length = strlen(names[0]);
    for (int i = 1; i < count; i++)
        for (size_t at = 0; at < length; at++)
            if (names[i][at] != names[0][at])
                length = at;
    while (length > 0 && names[0][length - 1] != '-')
        length--;
    if (length == 0 || length >= sizeof prefix)
        return 0;
    snprintf(prefix, sizeof prefix, "%.*s", (int)length, names[0]);
    for (int i = 0; i < count; i++)
        if (!names[i][length]) // nobody's name is empty
            return 0;
    return lab_name_find(id, prefix) ? (int)length : 0;
}

int hand_in_compare(const HandInName *a, const HandInName *b) {
    const bool numbers = isdigit((unsigned char)a->attempt[0]) && isdigit((unsigned char)b->attempt[0]);
    if (numbers && strlen(a->attempt) != strlen(b->attempt))
        return strlen(a->attempt) > strlen(b->attempt) ? 1 : -1;
    return strcmp(a->attempt, b->attempt);
}

bool hand_in_same_student(const char *id, const char *student, const char *other_id,
                          const char *other_student) {
    return id[0] ? strcmp(id, other_id) == 0 : !other_id[0] && strcmp(student, other_student) == 0;
}
