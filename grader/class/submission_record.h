// What is known of one submission: OUT/results/NAME.json (class/record.schema.json) and its page
// OUT/pages/NAME.html.
#pragma once

#include "report/report.h"
#include "class/roster.h"

#include <stdbool.h>

// Writes the page and then, as the sign that all is there, the record. False with a message.
bool submission_record_write(const char *output, const RosterEntry *entry, const Report *report);

// Writes a record that says that the submission could not be graded for a reason of ours, and removes the
// page.
bool submission_record_write_failure(const char *output, const RosterEntry *entry, const char *reason);

// The record, to be freed by the caller (json_decref); NULL when there is none that is whole.
json_t *submission_record_read(const char *output, const RosterEntry *entry);

// Is this the record of a graded submission? NULL is not.
bool submission_record_is_graded(const json_t *record);
