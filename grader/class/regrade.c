#include "class/regrade.h"

#include "class/run_log.h"
#include "class/submission_record.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_REASONS = 2 + COURSE_MAX_LABS };

typedef struct Reasons {
    char texts[MOST_REASONS][ORIGIN_TEXT];
    int counts[MOST_REASONS];
    int count;
} Reasons;

static void count_reason(Reasons *reasons, const char *why) {
    int i = 0;
    while (i < reasons->count && strcmp(reasons->texts[i], why) != 0)
        i++;
    INVARIANT(i < MOST_REASONS);
    if (i == reasons->count)
        snprintf(reasons->texts[reasons->count++], ORIGIN_TEXT, "%s", why);
    reasons->counts[i]++;
}

static void say(const Reasons *reasons, const char *output) {
    for (int i = 0; i < reasons->count; i++) {
        printf("graded again: %d with %s than when they were graded\n", reasons->counts[i],
               reasons->texts[i]);
        run_log(output, "graded again: %d with %s", reasons->counts[i], reasons->texts[i]);
    }
    fflush(stdout);
}

int regrade_choose(int *numbers, const char *output, const Roster *roster, const RunSettings *plan,
                   const Origin *origin, bool aloud) {
    Reasons reasons = {.count = 0};
    char why[ORIGIN_TEXT];
    int count = 0;
    for (int i = 0; i < roster->count; i++) {
        json_t *record = submission_record_read(output, &roster->entries[i]);
        const bool graded = submission_record_is_graded(record);
        why[0] = '\0';
        if (graded) {
            const HandInFacts facts = hand_in_facts(roster, &roster->entries[i]);
            origin_differs(why, record, origin, plan, &facts.hash);
        }
        if (why[0])
            count_reason(&reasons, why);
        if (!graded || why[0])
            numbers[count++] = i;
        json_decref(record);
    }
    if (aloud)
        say(&reasons, output);
    return count;
}
