// One loop in the parent gives jobs to its children over sockets, waits for outcomes, and starts another
// child in the place of one that died or took too long.
#include "base/pool.h"

#include "scene/check.h"
#include "base/process.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MAX_PROCESSES = 256, GIVE_UP = 8 };

typedef struct Hand {
    pid_t pid; // 0: none
    int socket;
    int job, tries; // the job, -1: idle; and which try it is
    double deadline;
} Hand;

typedef struct Todo {
    int job, tries; // tries: those that failed
} Todo;

typedef struct PoolRun {
    const Pool *pool;
    Hand hands[MAX_PROCESSES];
    Todo *queue; // room for every try
    int next, end;
    int done, failed; // jobs, for giving up
} PoolRun;

static _Noreturn void serve(const Pool *pool, int socket, pid_t parent) {
    static Outcome outcome;
    int job;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(1);
    while (read(socket, &job, sizeof job) == sizeof job) {
        memset(&outcome, 0, sizeof outcome);
        outcome.job = job;
        check_clear();
        pool->work(&outcome, pool->context);
        if (write(socket, &outcome, sizeof outcome) != sizeof outcome || !outcome.done)
            break; // after a fault of ours nothing here is to be trusted
    }
    _exit(0);
}

static bool start(PoolRun *run, Hand *hand) {
    int ends[2];
    pid_t parent = getpid();
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
        return check_fail("no socket to a process: %s", strerror(errno));
    hand->pid = fork();
    if (hand->pid == 0) {
        for (int i = 0; i < run->pool->processes; i++)
            if (run->hands[i].pid > 0)
                close(run->hands[i].socket);
        close(ends[0]);
        serve(run->pool, ends[1], parent);
    }
    close(ends[1]);
    hand->socket = ends[0];
    hand->job = -1;
    if (hand->pid > 0)
        return true;
    close(ends[0]);
    hand->pid = 0;
    return check_fail("no process: %s", strerror(errno));
}

static bool give(PoolRun *run, Hand *hand) {
    if (run->next == run->end || (hand->pid == 0 && !start(run, hand)))
        return run->next == run->end;
    const Todo *todo = &run->queue[run->next++];
    hand->job = todo->job;
    hand->tries = todo->tries;
    hand->deadline = process_now() + run->pool->seconds;
    if (send(hand->socket, &hand->job, sizeof hand->job, MSG_NOSIGNAL) != sizeof hand->job)
        hand->deadline = 0; // it is gone: found out when we wait
    return true;
}

// Takes the outcome of a try: the end of the job, or it is put back at the end of the queue.
static void settle(PoolRun *run, Hand *hand, const Outcome *outcome) {
    hand->job = -1;
    if (!outcome->done && ++hand->tries < run->pool->tries) {
        run->queue[run->end++] = (Todo){outcome->job, hand->tries};
        return;
    }
    run->done += outcome->done;
    run->failed += !outcome->done;
    run->pool->finished(outcome, run->pool->context);
}

static void bury(Hand *hand, int *status) {
    kill(hand->pid, SIGKILL);
    while (waitpid(hand->pid, status, 0) < 0 && errno == EINTR)
        ;
    close(hand->socket);
    hand->pid = 0;
}

// The process of this hand has ended or hangs.
static void lose(PoolRun *run, Hand *hand, bool late) {
    static Outcome outcome;
    int status = 0, job = hand->job;
    if (late)
        kill(hand->pid, SIGKILL);
    bury(hand, &status);
    if (job < 0)
        return;
    outcome = (Outcome){.job = job};
    if (late)
        snprintf(outcome.reason, sizeof outcome.reason, "the grader hung and was stopped after %.0f s",
                 run->pool->seconds);
    else if (WIFSIGNALED(status))
        snprintf(outcome.reason, sizeof outcome.reason, "the grader itself died: %s",
                 strsignal(WTERMSIG(status)));
    else
        snprintf(outcome.reason, sizeof outcome.reason, "the grader itself ended with exit status %d",
                 WEXITSTATUS(status));
    settle(run, hand, &outcome);
}

static void hear(PoolRun *run, Hand *hand) {
    static Outcome outcome;
    int status;
    if (recv(hand->socket, &outcome, sizeof outcome, 0) != sizeof outcome) {
        lose(run, hand, false);
        return;
    }
    settle(run, hand, &outcome);
    if (!outcome.done)
        bury(hand, &status);
}

static int wait_milliseconds(const PoolRun *run) {
    double first = process_now() + 3600;
    for (int i = 0; i < run->pool->processes; i++)
        if (run->hands[i].job >= 0 && run->hands[i].deadline < first)
            first = run->hands[i].deadline;
    double left = first - process_now();
    return left > 0 ? (int)(1000 * left) + 1 : 0;
}

// Waits for something to happen, and sees to it. False when no hand is at work.
static bool attend(PoolRun *run) {
    struct pollfd events[MAX_PROCESSES];
    int busy = 0;
    for (int i = 0; i < run->pool->processes; i++) {
        events[i] =
            (struct pollfd){.fd = run->hands[i].job >= 0 ? run->hands[i].socket : -1, .events = POLLIN};
        busy += run->hands[i].job >= 0;
    }
    if (busy == 0)
        return false;
    poll(events, (nfds_t)run->pool->processes, wait_milliseconds(run));
    for (int i = 0; i < run->pool->processes; i++) {
        Hand *hand = &run->hands[i];
        if (hand->job >= 0 && events[i].revents)
            hear(run, hand);
        else if (hand->job >= 0 && process_now() > hand->deadline)
            lose(run, hand, true);
    }
    return true;
}

static bool work_off(PoolRun *run) {
    do {
        for (int i = 0; i < run->pool->processes; i++)
            if (run->hands[i].job < 0 && !give(run, &run->hands[i]))
                return false;
        if (run->done == 0 && run->failed >= GIVE_UP)
            return check_fail("%d jobs after another could not be done", run->failed);
    } while (attend(run));
    return true;
}

bool pool_run(const Pool *pool, const int *jobs, int count) {
    static PoolRun run;
    int status;
    INVARIANT(pool->processes <= MAX_PROCESSES);
    run = (PoolRun){.pool = pool, .queue = calloc((size_t)(count * pool->tries) + 1, sizeof *run.queue)};
    INVARIANT(run.queue);
    for (int i = 0; i < count; i++)
        run.queue[run.end++] = (Todo){jobs[i], 0};
    for (int i = 0; i < pool->processes; i++)
        run.hands[i].job = -1;
    bool ok = work_off(&run);
    for (int i = 0; i < pool->processes; i++)
        if (run.hands[i].pid > 0)
            bury(&run.hands[i], &status);
    free(run.queue);
    return ok;
}
