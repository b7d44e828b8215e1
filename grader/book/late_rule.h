// What handing in late costs: a file that a lecturer writes (book/README.md).
#pragma once

#include "base/option_values.h"

#include <stdbool.h>
#include <time.h>

typedef struct LateRule {
    bool given;
    char labs[COURSE_MAX_LABS][3]; // with a due date, in the order of the dates
    time_t due[COURSE_MAX_LABS];
    int count;
    double grace;   // seconds after it that nobody counts
    int free_days;  // of each student, for all labs together
    double percent; // of the measured points, taken for each other day that has begun
    double cap;     // percent that are taken at most
} LateRule;

// Reads the JSON file. False with a message.
bool late_rule_read(LateRule *rule, const char *path);

// By how many seconds is this too late for the lab, the grace left aside? 0 also for a lab without a due date
// and for the time 0, which is unknown.
double late_rule_seconds(const LateRule *rule, const char *lab, time_t handed_in);

// How many days too late is this for the lab? A day that has begun counts. 0 also for a lab without a due
// date and for the time 0, which is unknown.
int late_rule_days(const LateRule *rule, const char *lab, time_t handed_in);

// The share of the points that so many days, none of them free, take: 0 to 1.
double late_rule_share(const LateRule *rule, int days);
