// Rounds are files that are made once and never changed: one mark a line, as 16 digits.
#include "class/rounds.h"

#include "base/siphash.h"
#include "class/hand_in_facts.h"
#include "class/hand_in_name.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = 17, MOST_MARKS = 1 << 20 };

// The marks of the roster's entries, as they are now.
typedef struct MarkList {
    uint64_t *marks;
    bool *open; // in no round yet
} MarkList;

static int by_mark(const void *a, const void *b) {
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

static void place(char path[FILES_PATH], const Rounds *rounds, int round) {
    const int length = snprintf(path, FILES_PATH, "%s/rounds/%d", rounds->output, round + 1);
    INVARIANT(length < FILES_PATH);
}

static uint64_t seed_of(uint64_t secret, const char *text) {
    static const char kind[] = "round";
    const uint64_t start = siphash((const uint64_t[2]){secret, 0}, kind, sizeof kind);
    return siphash((const uint64_t[2]){secret, start}, text, strlen(text));
}

static bool take_marks(HandInRound *round, const char *text) {
    const size_t length = strlen(text);
    round->count = (int)(length / LINE);
    round->marks = calloc((size_t)round->count + 1, sizeof *round->marks);
    INVARIANT(round->marks);
    for (int i = 0; i < round->count; i++) {
        const char *line = text + (size_t)i * LINE;
        if (strspn(line, "0123456789abcdef") != LINE - 1 || line[LINE - 1] != '\n')
            return false;
        round->marks[i] = strtoull(line, NULL, 16);
    }
    return length > 0 && length % LINE == 0;
}

static bool read_round(Rounds *rounds, const char *path) {
    char *text = files_read(path, (size_t)MOST_MARKS * LINE);
    HandInRound round = {0};
    const bool ok =
        text && (take_marks(&round, text) || check_fail("%s is not what build/grade wrote there", path));
    if (ok) {
        round.seed = seed_of(rounds->secret, text);
        rounds->list = realloc(rounds->list, sizeof *rounds->list * (size_t)(rounds->count + 1));
        INVARIANT(rounds->list);
        rounds->list[rounds->count++] = round;
    } else {
        free(round.marks);
    }
    free(text);
    return ok;
}

// Those that have begun since.
static bool read_new(Rounds *rounds) {
    char path[FILES_PATH];
    bool ok = true;
    for (place(path, rounds, rounds->count); ok && files_exists(path); place(path, rounds, rounds->count))
        ok = read_round(rounds, path);
    return ok;
}

// The number of the round; -1: none.
static int find(const Rounds *rounds, uint64_t mark) {
    for (int i = 0; i < rounds->count; i++)
        if (bsearch(&mark, rounds->list[i].marks, (size_t)rounds->list[i].count, sizeof mark, by_mark))
            return i;
    return -1;
}

static bool same_student(const RosterEntry *a, const RosterEntry *b) {
    return hand_in_same_student(a->id, a->student, b->id, b->student);
}

static MarkList look(const Rounds *rounds) {
    const Roster *roster = rounds->roster;
    MarkList now = {calloc((size_t)roster->count + 1, sizeof *now.marks),
                    calloc((size_t)roster->count + 1, sizeof *now.open)};
    INVARIANT(now.marks && now.open);
    for (int i = 0; i < roster->count; i++)
        now.open[i] = hand_in_mark(&now.marks[i], roster, &roster->entries[i], rounds->secret) &&
                      find(rounds, now.marks[i]) < 0;
    return now;
}

static bool is_first_open(const Rounds *rounds, const MarkList *now, int i) {
    const RosterEntry *entries = rounds->roster->entries;
    bool first = now->open[i];
    for (int j = 0; first && entries[i].attempts > 1 && j < i; j++)
        first = !(now->open[j] && now->marks[j] != now->marks[i] && same_student(&entries[j], &entries[i]));
    return first;
}

// The text of a round with these marks.
static char *write_marks(uint64_t *marks, int count) {
    char *text = calloc((size_t)count * LINE + 1, 1), *end = text;
    INVARIANT(text);
    qsort(marks, (size_t)count, sizeof *marks, by_mark);
    for (int i = 0; i < count; i++)
        if (i == 0 || marks[i] != marks[i - 1])
            end += snprintf(end, LINE + 1, "%016llx\n", (unsigned long long)marks[i]);
    return text;
}

// Does nothing where another process has begun it.
static bool begin(const Rounds *rounds) {
    char path[FILES_PATH];
    MarkList now = look(rounds);
    int count = 0;
    uint64_t *marks = calloc((size_t)rounds->roster->count + 1, sizeof *marks);
    INVARIANT(marks);
    for (int i = 0; i < rounds->roster->count; i++)
        if (is_first_open(rounds, &now, i))
            marks[count++] = now.marks[i];
    char *text = write_marks(marks, count);
    place(path, rounds, rounds->count);
    const bool ok = count == 0 ? check_fail("hand-ins are changed while they are graded: try again")
                               : files_write_whole(path, text, false);
    free(text);
    free(marks);
    free(now.marks);
    free(now.open);
    return ok;
}

bool rounds_meet(Rounds *rounds, const RosterEntry *entry, Meeting *meeting) {
    bool known = false, ok = read_new(rounds);
    *meeting = (Meeting){0};
    while (ok && !known) {
        meeting->alone = !hand_in_mark(&meeting->mark, rounds->roster, entry, rounds->secret);
        meeting->round = find(rounds, meeting->mark);
        known = meeting->alone || meeting->round >= 0;
        ok = known || (begin(rounds) && read_new(rounds));
    }
    if (ok && !meeting->alone)
        meeting->seed = rounds->list[meeting->round].seed;
    return ok;
}

bool rounds_same(const Rounds *rounds, const RosterEntry *entry, const Meeting *meeting) {
    uint64_t mark;
    const bool alone = !hand_in_mark(&mark, rounds->roster, entry, rounds->secret);
    return (alone == meeting->alone && mark == meeting->mark) ||
           check_fail("it was changed while it was graded");
}

static int by_round(const void *a, const void *b, void *context) {
    const int x = *(const int *)a, y = *(const int *)b;
    const int *of = context;
    return of[x] != of[y] ? of[x] - of[y] : x - y;
}

bool rounds_sort(Rounds *rounds, int *numbers, int count) {
    int *of = calloc((size_t)rounds->roster->count + 1, sizeof *of);
    bool ok = true;
    INVARIANT(of);
    for (int i = 0; ok && i < count; i++) {
        Meeting meeting;
        ok = rounds_meet(rounds, &rounds->roster->entries[numbers[i]], &meeting);
        of[numbers[i]] = meeting.alone ? -1 : meeting.round;
    }
    qsort_r(numbers, (size_t)count, sizeof *numbers, by_round, of);
    free(of);
    return ok;
}

void rounds_destroy(Rounds *rounds) {
    for (int i = 0; i < rounds->count; i++)
        free(rounds->list[i].marks);
    free(rounds->list);
    *rounds = (Rounds){0};
}
