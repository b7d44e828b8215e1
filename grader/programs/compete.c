// compete: ranks hand-ins of a lab by what their methods cost, without times. See compete/README.md.
#include "base/command_line.h"
#include "base/option_values.h"
#include "book/pseudonyms.h"
#include "class/roster.h"
#include "compete/board.h"
#include "compete/entrant.h"
#include "exam/handed_out.h"
#include "exam/exam_seeds.h"
#include "jail/jail.h"
#include "jail/jail_choose.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EXIT_ALL_RANKED, EXIT_SOME, EXIT_COULD_NOT = 3 };

typedef struct Compete {
    char lab[3];
    const char *arena, *class, *page, *results, *pseudonyms;
    const char *submission;
    JailRoute route;
    bool trusted;
    ContextKind context;
} Compete;

typedef struct Contest {
    Arena arena;
    Session session;
    Jail jail;
    Standing *standings; // owned
    int count;
} Contest;

#define AT(field) offsetof(Compete, field)
static const Option options[] = {
    {"lab", 0, "NN", "the lab", AT(lab), option_lab},
    {"arena", 0, "DIR", "the cameras, as build/record_arena writes them", AT(arena), option_text},
    {"class", 0, "DIR", "the hand-ins of a class, as build/grade --class takes them", AT(class), option_text},
    {"page", 0, "FILE", "the standings as a page, too", AT(page), option_text},
    {"anonymous", 0, "FILE", "pseudonyms, which FILE keeps: keep it secret; as build/grade --anonymous",
     AT(pseudonyms), option_text},
    {"results", 0, "FILE", "adds the key \"leaderboard\" to this results.json of Gradescope", AT(results),
     option_text},
    {"context", 0, "C", "osmesa or egl (default: the first that is here)", AT(context), option_context},
    {"jail", 0, "ROUTE", "bwrap or landlock: only this jail (default: the first that holds)", AT(route),
     jail_take_route},
    {"trusted", 0, NULL, "no jail: the submission is my own work", AT(trusted), option_flag},
    {0}};
#undef AT

static bool check(void *settings, const Operands *operands) {
    Compete *command = settings;
    command->submission = operands->count ? operands->texts[0] : NULL;
    if (!command->lab[0] || !command->arena)
        return check_fail("--lab NN and --arena DIR are needed");
    if (!command->class == !command->submission)
        return check_fail("give one SUBMISSION, or --class DIR");
    if (command->class && (command->results || command->trusted))
        return check_fail("--results and --trusted are for one SUBMISSION");
    return !command->pseudonyms || command->class || check_fail("--anonymous goes with --class");
}

static const CommandLine command_line = {
    .program = "compete",
    .forms = "--lab NN --arena DIR [options] SUBMISSION\n--lab NN --arena DIR [options] --class DIR",
    .about = "Ranks methods by what they cost on any machine, at an error that the contest allows.\n",
    .options = options,
    .ending = "exit status: 0 all are ranked; 1 some are not; 2 usage; 3 it could not be measured\n",
    .operand = "SUBMISSION",
    .most = 1,
    .check = check,
};

static bool run(Contest *contest, const char *path, const char *name) {
    contest->standings =
        realloc(contest->standings, (size_t)(contest->count + 1) * sizeof *contest->standings);
    INVARIANT(contest->standings);
    Standing *standing = &contest->standings[contest->count++];
    *standing = (Standing){0};
    snprintf(standing->name, sizeof standing->name, "%s", name);
    return entrant_run(standing, &contest->arena, &contest->session, path);
}

// Who it is: as the gradebook's pseudonyms know it.
static const char *key_of(const RosterEntry *entry) {
    return entry->id[0] ? entry->id : entry->student;
}

static bool run_entry(Contest *contest, const Roster *roster, int i, char *const *names) {
    char path[FILES_PATH];
    const RosterEntry *entry = &roster->entries[i];
    bool made = false;
    const bool ok =
        roster_fetch(roster, entry, path, &made) && run(contest, path, names ? names[i] : entry->student);
    if (made)
        files_remove(path);
    return ok;
}

static bool run_class(Contest *contest, const Compete *command) {
    Roster roster = {0};
    char **names = NULL;
    bool ok = roster_read(&roster, command->class, NULL, false);
    if (ok && command->pseudonyms) {
        const char **keys = calloc((size_t)roster.count + 1, sizeof *keys);
        INVARIANT(keys);
        for (int i = 0; i < roster.count; i++)
            keys[i] = key_of(&roster.entries[i]);
        ok = pseudonyms_of(&names, keys, roster.count, command->pseudonyms);
        free(keys);
    }
    for (int i = 0; ok && i < roster.count; i++)
        ok = run_entry(contest, &roster, i, names);
    pseudonyms_free(names);
    roster_destroy(&roster);
    return ok;
}

static bool write_page(const Contest *contest, const char *path) {
    char *page = board_page(contest->standings, contest->count, &contest->arena);
    const bool ok = page && files_write_whole(path, page, true);
    free(page);
    return ok;
}

// Where there are no solutions, only recorded exams can grade.
static bool choose_seed(const Arena *arena, uint64_t *seed) {
    *seed = arena->seed;
    return !handed_out_alone() || exam_seeds_list(seed, 1) == 1;
}

static bool open_contest(Contest *contest, const Compete *command) {
    Session *session = &contest->session;
    if (!arena_read(&contest->arena, command->arena, command->lab) ||
        !choose_seed(&contest->arena, &session->options.seed) || !session_add(session, command->lab))
        return false;
    session->keep = true;
    session->options.context = command->context;
    session->options.seconds = 60;
    session->options.no_swap = session->options.untimed = true;
    session->options.hidden = command->class || command->results; // who handed it in reads the reasons
    return jail_choose(&contest->jail, command->route, command->trusted, "compete", &session->options.jail);
}

static bool finish(Contest *contest, const Compete *command) {
    standing_sort(contest->standings, contest->count);
    board_print(contest->standings, contest->count, &contest->arena, stdout);
    return (!command->page || write_page(contest, command->page)) &&
           (!command->results || board_add_to_results(&contest->standings[0], command->results));
}

static int compete(const Compete *command) {
    static Contest contest;
    const bool ok =
        open_contest(&contest, command) &&
        (command->class ? run_class(&contest, command) : run(&contest, command->submission, "you")) &&
        finish(&contest, command);
    int status = ok ? EXIT_ALL_RANKED : EXIT_COULD_NOT;
    for (int i = 0; ok && i < contest.count; i++)
        status = contest.standings[i].ranked ? status : EXIT_SOME;
    if (!ok)
        fprintf(stderr, "compete: %s\n", check_message());
    session_close(&contest.session);
    jail_destroy(&contest.jail);
    arena_destroy(&contest.arena);
    free(contest.standings);
    return status;
}

int main(int count, char **arguments) {
    static Compete command;
    command_line_take(&command_line, &command, count, arguments);
    command_line_settle_context(&command_line, &command.context);
    return compete(&command);
}
