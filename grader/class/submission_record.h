// What is known of one submission: OUT/results/NAME.json (class/record.schema.json) and its page
// OUT/pages/NAME.html.
#pragma once

#include "report/report.h"
#include "class/origin.h"
#include "class/roster.h"

#include <stdbool.h>

// Writes the page and then, as the sign that all is there, the record. `made_of` is origin_json's and is
// taken over. False with a message.
bool submission_record_write(const char *output, const RosterEntry *entry, const Report *report,
                             json_t *made_of, const HandInFacts *facts);

// Writes a record that says that the submission could not be graded for a reason of ours, and removes the
// page.
bool submission_record_write_failure(const char *output, const RosterEntry *entry, const char *reason);

// The record, to be freed by the caller (json_decref); NULL when there is none that is whole.
json_t *submission_record_read(const char *output, const RosterEntry *entry);

// When it was handed in, by a record; 0 when it does not tell. *told: by the name of the hand-in.
time_t submission_record_time(const json_t *record, bool *told);

// Is this the record of a graded submission? NULL is not.
bool submission_record_is_graded(const json_t *record);
