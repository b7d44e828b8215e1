// Starts a child in a session of its own with its limits, moves bytes both ways with one poll, and kills and
// collects all that it left.
#include "base/process.h"

#include "base/memory.h"
#include "base/process_child.h"
#include "scene/check.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static const double LAST_WORDS = 0.3; // seconds

double process_now(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static bool make_pipes(int pipes[3][2]) {
    for (int i = 0; i < 3; i++)
        if (pipe2(pipes[i], O_CLOEXEC) != 0) {
            check_fail("no pipe to a child process: %s", strerror(errno));
            while (i-- > 0)
                close(pipes[i][0]), close(pipes[i][1]);
            return false;
        }
    return true;
}

bool process_open(Process *process, int theirs[3], const ProcessLimits *limits) {
    enum { INPUT, OUTPUT, REPLIES };
    int pipes[3][2];
    memset(process, 0, sizeof *process);
    if (!make_pipes(pipes))
        return false;
    theirs[0] = pipes[INPUT][0];
    theirs[1] = pipes[OUTPUT][1];
    theirs[2] = pipes[REPLIES][1];
    signal(SIGPIPE, SIG_IGN);         // a child that died while we write to it is a failed write
    prctl(PR_SET_CHILD_SUBREAPER, 1); // what its death leaves behind becomes our child: see collect
    process->input = pipes[INPUT][1];
    process->output = pipes[OUTPUT][0];
    process->replies = pipes[REPLIES][0];
    process->deadline = process_now() + limits->wall_seconds;
    process->resident_mib = limits->resident_mib;
    fcntl(process->input, F_SETFL, O_NONBLOCK);
    return true;
}

bool process_opened(Process *process, const int theirs[3], pid_t pid) {
    const int why = errno;
    for (int i = 0; i < 3; i++)
        close(theirs[i]);
    process->pid = pid > 0 ? pid : 0;
    if (pid > 0)
        return true;
    process_stop(process);
    return check_fail("no child process: %s", strerror(why));
}

bool process_start(Process *process, char *const *arguments, char *const *environment, const char *folder,
                   const ProcessLimits *limits) {
    int theirs[3];
    const pid_t parent = getpid();
    if (!process_open(process, theirs, limits))
        return false;
    const pid_t pid = fork();
    if (pid == 0)
        process_child_run(theirs, arguments, environment, folder, limits, parent);
    if (pid > 0 && !limits->untrusted)
        setpgid(pid, pid);
    return process_opened(process, theirs, pid);
}

// Takes what the process prints: the first PROCESS_OUTPUT bytes are kept, the rest only counted.
static bool take_output(Process *process) {
    char block[16 * 1024];
    ssize_t n = read(process->output, block, sizeof block);
    if (n <= 0)
        return false;
    size_t kept = process->printed < PROCESS_OUTPUT - 1 ? process->printed : PROCESS_OUTPUT - 1;
    size_t room = PROCESS_OUTPUT - 1 - kept, take = (size_t)n < room ? (size_t)n : room;
    memcpy(process->text + kept, block, take);
    process->printed += (size_t)n;
    if (process->printed > PROCESS_FLOOD)
        process->state = PROCESS_FLOODED;
    return true;
}

static void close_end(int *descriptor) {
    if (*descriptor >= 0)
        close(*descriptor);
    *descriptor = -1;
}

// Waits until something can be done. False when the time is over.
static bool wait_for_event(Process *process, struct pollfd *events) {
    int ready = 0;
    while (ready == 0 && process->state == PROCESS_RUNNING) {
        const double left = process->deadline - process_now();
        const double slice = process->resident_mib ? PROCESS_MEMORY_SLICE : PROCESS_SLICE;
        if (left <= 0 || process->cancelled)
            process->state = PROCESS_TIMED_OUT;
        else if (process->resident_mib && !memory_within(process->pid, process->resident_mib))
            process->state = PROCESS_TOO_LARGE;
        else
            ready = poll(events, 3, (int)(fmin(left, slice) * 1000) + 1);
    }
    return process->state == PROCESS_RUNNING;
}

static bool reap_one(Process *process, pid_t who, int *status) {
    struct rusage usage = {0};
    pid_t pid;
    while ((pid = wait4(who, status, 0, &usage)) < 0 && errno == EINTR)
        ;
    process->cpu_seconds += (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
                            1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
    if (usage.ru_maxrss / 1024 > process->peak_mib)
        process->peak_mib = usage.ru_maxrss / 1024;
    return pid > 0;
}

// Waits for the process itself, then kills and collects its whole group: orphans come to us, the subreaper.
static void collect(Process *process) {
    int ignored;
    pid_t group = process->pid;
    process->pid = 0;
    reap_one(process, group, &process->status);
    if (process->wrapped && WIFEXITED(process->status) && WEXITSTATUS(process->status) > 128)
        process->status = WEXITSTATUS(process->status) - 128;
    kill(-group, SIGKILL);
    while (reap_one(process, -group, &ignored))
        ;
}

static void kill_all(Process *process) {
    if (process->pid <= 0)
        return;
    kill(process->pid, SIGKILL);
    kill(-process->pid, SIGKILL);
    collect(process);
}

// Waits for the end of the process itself, which has closed its output.
static void wait_for_end(Process *process) {
    siginfo_t info = {0};
    while (waitid(P_PID, (id_t)process->pid, &info, WEXITED | WNOWAIT | WNOHANG) == 0 && info.si_pid == 0 &&
           process_now() < process->deadline)
        usleep(500);
    if (info.si_pid == 0)
        process->state = PROCESS_TIMED_OUT;
    else
        collect(process);
}

// Its time is over. What watches for SIGXCPU may say in a moment where it was; the others die by it or go on.
static void hear_last_words(Process *process) {
    const double end = process_now() + LAST_WORDS;
    const ProcessState state = process->state;
    kill(-process->pid, SIGXCPU);
    while (process->output >= 0 && process_now() < end) {
        struct pollfd event = {.fd = process->output, .events = POLLIN};
        if (poll(&event, 1, 20) > 0 && !take_output(process))
            break;
    }
    process->state = state;
}

// The process has closed its replies: it is ending. Give it until the deadline to do so, then collect it.
static void reap(Process *process) {
    while (process->state == PROCESS_RUNNING && process->pid > 0) {
        struct pollfd events[3] = {{.fd = process->output, .events = POLLIN}, {.fd = -1}, {.fd = -1}};
        if (process->output >= 0 && !wait_for_event(process, events))
            break;
        if (process->output < 0 || !take_output(process))
            wait_for_end(process);
    }
    if (process->state == PROCESS_RUNNING)
        process->state = PROCESS_ENDED;
    if (process->state == PROCESS_TIMED_OUT && !process->cancelled && process->pid > 0)
        hear_last_words(process);
    kill_all(process);
}

// It lives, but its pipes fail on our side.
static void give_up(Process *process) {
    kill_all(process);
    process->state = PROCESS_DEAF;
}

// False when it has closed its input.
static bool send_some(Process *process, const char *request, size_t size, size_t *sent) {
    ssize_t n = write(process->input, request + *sent, size - *sent);
    if (n < 0 && errno == EPIPE)
        return false;
    if (n < 0 && errno != EAGAIN && errno != EINTR)
        give_up(process);
    *sent += n > 0 ? (size_t)n : 0;
    return true;
}

bool process_exchange(Process *process, const void *request, size_t request_size, void *reply,
                      size_t reply_size) {
    size_t sent = 0, taken = 0;
    while (process->state == PROCESS_RUNNING && taken < reply_size) {
        struct pollfd events[3] = {{.fd = process->replies, .events = POLLIN},
                                   {.fd = process->output, .events = POLLIN},
                                   {.fd = sent < request_size ? process->input : -1, .events = POLLOUT}};
        if (!wait_for_event(process, events))
            break;
        if (events[1].revents && !take_output(process))
            close_end(&process->output);
        if (events[2].revents && !send_some(process, request, request_size, &sent))
            break;
        if (events[0].revents) {
            ssize_t n = read(process->replies, (char *)reply + taken, reply_size - taken);
            if (n < 0 && errno != EINTR)
                give_up(process);
            if (n == 0)
                break;
            taken += n > 0 ? (size_t)n : 0;
        }
    }
    if (taken == reply_size)
        return true;
    if (process->state != PROCESS_DEAF)
        reap(process);
    return false;
}

bool process_take_rest(Process *process, void *reply, size_t size) {
    size_t taken = 0;
    if (process->deadline <= 0 || process->replies < 0)
        return false; // it was never started
    fcntl(process->replies, F_SETFL, O_NONBLOCK);
    for (ssize_t n = 1; n > 0 && taken<size; taken += n> 0 ? (size_t)n : 0)
        n = read(process->replies, (char *)reply + taken, size - taken);
    return taken == size;
}

void process_forget_output(Process *process) {
    process->printed = 0;
    process->text[0] = '\0';
}

void process_wait(Process *process) {
    close_end(&process->input);
    reap(process);
}

void process_stop(Process *process) {
    kill_all(process);
    if (process->deadline > 0) {
        close_end(&process->input);
        close_end(&process->output);
        close_end(&process->replies);
    }
    process->deadline = 0;
}
