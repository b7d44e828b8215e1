// Rounds of a class: whoever could have seen pages of an exam meets another one.
#include "class/rounds.h"
#include "class/hand_in_facts.h"
#include "scene/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

static char work[FILES_PATH], class[FILES_PATH + 8];

// Text of a student's lab.c.
static void hand_in(const char *who, const char *text) {
    char path[FILES_PATH + 300];
    snprintf(path, sizeof path, "%s/%s/", class, who);
    assert_true(files_make_folder(path));
    strcat(path, "lab.c");
    assert_true(files_write_whole(path, text, true));
}

static int set_up(void **state) {
    (void)state;
    assert_true(files_make_temporary(work));
    snprintf(class, sizeof class, "%s/class", work);
    hand_in("Ann", "one");
    hand_in("Bo", "two");
    hand_in("Cy", "one");
    hand_in("Di", "three");
    hand_in("Di (1)", "four");
    hand_in("Di (2)", "four");
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    files_remove(work);
    return 0;
}

// A run of the class, as a new process of the grader sees it.
typedef struct RunOfClass {
    Roster roster;
    Rounds rounds;
    char output[FILES_PATH + 80];
} RunOfClass;

static void begin(RunOfClass *run, const char *output, uint64_t secret) {
    char path[FILES_PATH + 90];
    snprintf(run->output, sizeof run->output, "%s/%s", work, output);
    snprintf(path, sizeof path, "%s/rounds/", run->output);
    assert_true(files_make_folder(path));
    assert_true(roster_read(&run->roster, class, run->output, true));
    run->rounds = (Rounds){run->output, &run->roster, secret, NULL, 0};
}

static void end(RunOfClass *run) {
    rounds_destroy(&run->rounds);
    roster_destroy(&run->roster);
}

static uint64_t seed_in(RunOfClass *run, const char *who) {
    Meeting meeting;
    const int i = roster_find(&run->roster, who);
    assert_true(i >= 0);
    assert_true(rounds_meet(&run->rounds, &run->roster.entries[i], &meeting));
    assert_false(meeting.alone);
    assert_true(rounds_same(&run->rounds, &run->roster.entries[i], &meeting));
    return meeting.seed;
}

static uint64_t seed_of(const char *output, uint64_t secret, const char *who) {
    static RunOfClass run;
    begin(&run, output, secret);
    const uint64_t seed = seed_in(&run, who);
    end(&run);
    return seed;
}

static void test_one_round(void **state) {
    (void)state;
    const uint64_t first = seed_of("out", 7, "Bo");
    assert_int_equal(seed_of("out", 7, "Ann"), first);
    assert_int_equal(seed_of("out", 7, "Cy"), first);
    assert_int_equal(seed_of("again", 7, "Cy"), first); // the same class by the same seed
    assert_true(seed_of("other", 8, "Bo") != first);
}

// A student's attempts meet different exams, but where they are the same.
static void test_attempts(void **state) {
    (void)state;
    const uint64_t first = seed_of("out", 7, "Di"), second = seed_of("out", 7, "Di (1)");
    assert_true(first != second);
    assert_int_equal(seed_of("out", 7, "Di (2)"), second);
}

static void test_later(void **state) {
    (void)state;
    const uint64_t first = seed_of("out", 7, "Bo");
    hand_in("Bo", "changed");
    hand_in("Ed", "new");
    const uint64_t second = seed_of("out", 7, "Bo");
    assert_true(second != first);
    assert_int_equal(seed_of("out", 7, "Ed"), second); // it was there when Bo's round began
    hand_in("Flo", "later");
    const uint64_t third = seed_of("out", 7, "Flo");
    assert_true(third != first && third != second);
    assert_int_equal(seed_of("out", 7, "Ann"), first); // who is graded again
    hand_in("Bo", "two");
    assert_int_equal(seed_of("out", 7, "Bo"), first); // the same files
    hand_in("Flo", "one"); // who hands in what was there in the first round has learnt nothing from it
    assert_int_equal(seed_of("out", 7, "Flo"), first);
}

// Another class by the same seed meets another exam: it may know the first one's pages.
static void test_same_seed(void **state) {
    (void)state;
    const uint64_t first = seed_of("out", 7, "Bo");
    hand_in("Ann", "has learnt");
    assert_true(seed_of("again", 7, "Bo") != first);
}

static void test_changed_meanwhile(void **state) {
    (void)state;
    static RunOfClass run;
    Meeting meeting;
    begin(&run, "out", 7);
    const RosterEntry *ann = &run.roster.entries[roster_find(&run.roster, "Ann")];
    assert_true(rounds_meet(&run.rounds, ann, &meeting));
    hand_in("Ann", "other");
    assert_false(rounds_same(&run.rounds, ann, &meeting));
    check_clear();
    const uint64_t first = meeting.seed;
    assert_true(rounds_meet(&run.rounds, ann, &meeting));
    assert_true(meeting.seed != first);
    end(&run);
}

// Several processes of a cluster begin at once.
static void test_at_once(void **state) {
    (void)state;
    enum { PROCESSES = 8 };
    int ends[2];
    uint64_t first = 0, seed;
    assert_int_equal(pipe(ends), 0);
    for (int i = 0; i < PROCESSES; i++)
        if (fork() == 0) {
            seed = seed_of("out", 7, i % 2 ? "Ann" : "Bo");
            _exit(write(ends[1], &seed, sizeof seed) != sizeof seed);
        }
    for (int i = 0; i < PROCESSES; i++) {
        int status;
        assert_true(wait(&status) > 0 && status == 0);
        assert_int_equal(read(ends[0], &seed, sizeof seed), sizeof seed);
        first = i == 0 ? seed : first;
        assert_int_equal(seed, first);
    }
    close(ends[0]);
    close(ends[1]);
}

static void test_sorted(void **state) {
    (void)state;
    static RunOfClass run;
    seed_of("out", 7, "Ann");
    hand_in("Ann", "later");
    begin(&run, "out", 7);
    int numbers[6] = {0, 1, 2, 3, 4, 5}; // Ann, Bo, Cy, Di, Di (1), Di (2)
    assert_true(rounds_sort(&run.rounds, numbers, 6));
    assert_memory_equal(numbers, ((int[6]){1, 2, 3, 0, 4, 5}), sizeof numbers);
    end(&run);
}

// What is not looked at must not decide: it could be changed.
static void test_too_many(void **state) {
    (void)state;
    static RunOfClass run;
    Meeting meeting;
    char path[FILES_PATH + 300];
    for (int i = 0; i < 20001; i++) {
        snprintf(path, sizeof path, "%s/Ann/%d", class, i);
        FILE *file = fopen(path, "w");
        assert_non_null(file);
        fclose(file);
    }
    begin(&run, "out", 7);
    assert_true(rounds_meet(&run.rounds, &run.roster.entries[0], &meeting));
    assert_true(meeting.alone);
    seed_in(&run, "Bo");
    end(&run);
}

static void test_bad_list(void **state) {
    (void)state;
    static RunOfClass run;
    static const char *const bad[] = {"", "0123\n", "0123456789abcdeg\n", "0123456789abcdef",
                                      "0123456789abcdef\n0"};
    Meeting meeting;
    char path[FILES_PATH + 100];
    begin(&run, "out", 7);
    snprintf(path, sizeof path, "%s/rounds/1", run.output);
    for (int i = 0; i < 5; i++) {
        assert_true(files_write_whole(path, bad[i], true));
        assert_false(rounds_meet(&run.rounds, &run.roster.entries[0], &meeting));
        assert_non_null(strstr(check_message(), "rounds/1 is not what build/grade wrote there"));
        check_clear();
    }
    end(&run);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)

int main(void) {
    const struct CMUnitTest tests[] = {
        TEST(test_one_round),         TEST(test_attempts), TEST(test_later),
        TEST(test_same_seed),         TEST(test_at_once),  TEST(test_sorted),
        TEST(test_changed_meanwhile), TEST(test_too_many), TEST(test_bad_list)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
