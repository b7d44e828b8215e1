// Opens one hand-in after the other as the grader does, and prints lines instead of grading.
#include "book/dry_run.h"

#include "base/find_file.h"
#include "base/places.h"
#include "compile/lab_folder.h"
#include "compile/rubric_file.h"
#include "grade/found_lab.h"
#include "jail/jail.h"
#include "jail/jail_choose.h"
#include "predict/predictions.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NOTE = 600 };

typedef struct HandInLook {
    const Table *table;
    const Book *book;
    const Jail *jail;
    Rubric *rubrics; // of the plan's labs
    bool all_attempts;
    int fresh, again, kept, strange;
    bool needs_look; // the hand-in at hand
} HandInLook;

// Names of files may be any bytes.
static void say(const char *text, void *context) {
    (void)context;
    char *shown = printable_name(text);
    printf("        %s\n", shown);
    free(shown);
}

static void warn(HandInLook *look, const char *text) {
    char *shown = printable_name(text);
    printf("      ! %s\n", shown);
    free(shown);
    look->needs_look = true;
}

static void print_time(const HandInLook *look, int i, const HandInFacts *facts, time_t *time) {
    static const char *const by[CLOCK_COUNT] = {"", "by the list", "by its name",
                                                "by the files' times, which a student can set"};
    char text[BOOK_TIME_TEXT];
    BookClock clock;
    *time = book_time_of(book_student(look->book, &look->book->rows[i]), facts->time, facts->told, &clock);
    book_time_text(text, *time);
    if (text[0])
        printf("    handed in %s, %s\n", text, by[clock]);
    if (look->table->roster->entries[i].late)
        printf("    late, by its name\n");
}

static void print_predictions(HandInLook *look, const Rubric *rubric, const char *folder) {
    static Predictions predictions; // too large for a stack
    predictions_begin(&predictions, rubric);
    if (predictions_take(&predictions, rubric, folder) && predictions.message[0] && !predictions.undrawn)
        warn(look, predictions.message);
    check_clear();
}

// The files that would be taken, under the names that they have there; what is wrong with one of them.
static void print_files(HandInLook *look, const Rubric *rubric, const char *folder) {
    char found[FIND_FILE_NAME];
    int count = 0;
    for (int f = 0; f < rubric->file_count; f++)
        if (find_file(found, folder, rubric->files[f])) {
            char *shown = printable_name(found);
            printf("%s%s", count++ ? ", " : ": ", shown);
            free(shown);
        }
    puts(count ? "" : ": no file of it");
    check_clear();
    if (!found_lab_files(rubric, folder, say, NULL))
        warn(look, check_message());
    for (int f = 0; f < rubric->file_count; f++) {
        check_clear();
        char *text = find_file_read(folder, rubric->files[f], DERIVE_MAX_FILE);
        if (!text)
            warn(look, check_message());
        free(text);
    }
    check_clear();
    print_predictions(look, rubric, folder);
}

// False when nothing of the lab was found.
static bool print_lab(HandInLook *look, const Submission *submission, int n, time_t time) {
    const RunSettings *plan = look->table->plan;
    char note[NOTE];
    const char *folder = submission_find_of(submission, plan->labs[n], plan->lab_count, note, sizeof note);
    const int days = late_rule_days(&look->book->late, plan->labs[n], time);
    if (!folder)
        return false;
    char *shown = printable_name(submission_shown(submission, folder));
    printf("    lab %s: %s", plan->labs[n], shown);
    free(shown);
    if (days > 0)
        printf(" (%d day%s late)", days, days == 1 ? "" : "s");
    print_files(look, &look->rubrics[n], folder);
    if (note[0])
        warn(look, note);
    return true;
}

static void print_missing(HandInLook *look, const Submission *submission, const bool *found) {
    const RunSettings *plan = look->table->plan;
    char text[NOTE + FILES_PATH], names[COURSE_MAX_LABS * 4 + 1] = "";
    int missing = 0;
    for (int n = 0; n < plan->lab_count; n++)
        if (!found[n])
            check_append(names, sizeof names, "%s%s", missing++ ? ", " : "", plan->labs[n]);
    found_lab_missing(text, sizeof text, submission, &look->rubrics[0]);
    if (missing > 0 && missing < plan->lab_count)
        printf("    not found: lab %s\n", names);
    else if (missing > 0)
        warn(look, plan->lab_count == 1        ? text
                   : submission->why[0]        ? submission->why
                   : submission->lab_count > 0 ? "there is a lab.c, but nothing tells of which lab"
                                               : "there is no folder of a lab");
}

// False with a message when we or the machine are to blame.
static bool print_labs(HandInLook *look, int i, time_t time) {
    static Submission submission; // too large for a stack
    const Roster *roster = look->table->roster;
    bool made = false, found[COURSE_MAX_LABS] = {false};
    char path[FILES_PATH];
    Extracted opened = EXTRACT_FAULT;
    check_clear();
    if (roster_fetch(roster, &roster->entries[i], path, &made))
        opened = submission_open(&submission, look->jail, path);
    if (opened == EXTRACT_BAD_ARCHIVE)
        warn(look, check_message());
    for (int n = 0; opened == EXTRACT_OK && n < look->table->plan->lab_count; n++)
        found[n] = print_lab(look, &submission, n, time);
    if (opened == EXTRACT_OK)
        print_missing(look, &submission, found);
    if (opened == EXTRACT_OK && submission.note[0])
        warn(look, submission.note);
    submission_close(&submission);
    if (made)
        files_remove(path);
    return opened != EXTRACT_FAULT;
}

static void print_plan(HandInLook *look, int i, const HandInFacts *facts) {
    const Table *table = look->table;
    char why[ORIGIN_TEXT];
    if (!table_is_graded(table, i)) {
        look->fresh++;
        if (table->records[i])
            printf("    was not graded (%s): would be tried again\n", table_reason(table, i));
        return;
    }
    origin_differs(why, table->records[i], table->origin, table->plan, &facts->hash);
    look->again += why[0] != '\0';
    look->kept += why[0] == '\0';
    printf("    was graded, %.2f points: %s%s\n", table_total(table, i), why[0] ? "again, with " : "stays",
           why);
}

static bool print_hand_in(HandInLook *look, int i) {
    const RosterEntry *entry = &look->table->roster->entries[i];
    const BookRow *row = &look->book->rows[i];
    const HandInFacts facts = hand_in_facts(look->table->roster, entry);
    const char *id = book_id(look->book, row);
    time_t time;
    printf("%s%s%s%s: %s\n", book_name(look->book, row), id[0] ? " (" : "", id, id[0] ? ")" : "",
           entry->shown);
    look->needs_look = false;
    if (entry->loose_count > 0)
        printf("    %d loose files\n", entry->loose_count);
    if (entry->attempts > 1)
        printf("    %s %d attempts\n", look->all_attempts ? "one of" : "the newest of", entry->attempts);
    print_time(look, i, &facts, &time);
    if (!print_labs(look, i, time))
        return false;
    if (row->note)
        printf("      ! %s\n", row->note);
    print_plan(look, i, &facts);
    look->strange += look->needs_look || row->note;
    fflush(stdout);
    return true;
}

static void print_rest(const HandInLook *look, int count) {
    const Roster *roster = look->table->roster;
    int missing = 0;
    for (int i = 0; i < roster->ignored_count; i++)
        printf("ignored: %s: %s\n", roster->ignored[i].name, roster->ignored[i].why);
    for (int r = 0; r < look->book->count; r++)
        if (look->book->rows[r].entry < 0) {
            printf("handed in nothing: %s\n", book_name(look->book, &look->book->rows[r]));
            missing++;
        }
    printf("%d hand-ins: %d to be graded", count, look->fresh);
    if (look->again + look->kept > 0)
        printf(", %d graded again, %d stay", look->again, look->kept);
    printf("; %d need a look (!)", look->strange);
    if (look->book->listed)
        printf("; %d of %d on the list handed in nothing", missing, look->book->list.count);
    puts(". Nothing was graded or written.");
}

static bool print_all(HandInLook *look, const ClassSettings *settings) {
    const Roster *roster = look->table->roster;
    const int count = settings->only ? settings->only_count : roster->count;
    for (int k = 0; k < count; k++) {
        const int i = settings->only ? roster_find(roster, settings->only[k]) : k;
        if (i < 0 || !print_hand_in(look, i))
            return false;
    }
    print_rest(look, count);
    return true;
}

static bool load_rubrics(Rubric *rubrics, const RunSettings *plan) {
    char folder[FILES_PATH];
    for (int n = 0; n < plan->lab_count; n++)
        if (!places_find_lab(folder, plan->labs[n]) || !rubric_load(&rubrics[n], folder))
            return check_fail("there is no lab %s in solutions/", plan->labs[n]);
    return true;
}

bool dry_run_print(const Table *table, const ClassSettings *settings, void *context) {
    DryRun *run = context;
    Jail jail = {0};
    Book book = {0};
    HandInLook look = {.table = table,
                       .book = &book,
                       .all_attempts = settings->all_attempts,
                       .rubrics = calloc(COURSE_MAX_LABS, sizeof(Rubric))};
    INVARIANT(look.rubrics);
    const bool ok =
        load_rubrics(look.rubrics, table->plan) && book_open(&book, table, settings->output, &run->files) &&
        jail_choose(&jail, settings->route, false, "grade", &look.jail) && print_all(&look, settings);
    run->strange = look.strange;
    for (int n = 0; n < table->plan->lab_count; n++)
        rubric_destroy(&look.rubrics[n]);
    free(look.rubrics);
    book_close(&book);
    jail_destroy(&jail);
    return ok;
}
