#include "watch/viewer.h"

#include "base/places.h"
#include "watch/terminal.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

// An unnamed file; what the window prints must not come between us and the screen.
static int open_log(void) {
    char path[FILES_PATH];
    const char *parent = getenv("TMPDIR");
    files_join(path, parent ? parent : "/tmp", "shadow-lab-view-XXXXXX");
    const int log = mkostemp(path, O_CLOEXEC);
    if (log >= 0)
        unlink(path);
    return log;
}

// It gets a session of its own, so that it stays open when the watch ends.
static _Noreturn void run(const char *program, const char *id, const char *task, int log) {
    const char *arguments[6] = {program, "--lab", id};
    int count = 3;
    if (task[0])
        arguments[count++] = "--check", arguments[count++] = task;
    terminal_forget();
    setsid();
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    execv(program, (char *const *)arguments);
    _exit(127);
}

void viewer_open(Viewer *viewer, LabBoard *board) {
    const Rubric *rubric = &board->rubrics[board->current];
    const bool is_open = board->known && board->focus.check >= 0;
    char program[FILES_PATH], *message = board->message;
    const size_t size = sizeof board->message;
    places_build_path(program, "view");
    if (access(program, X_OK) != 0) {
        snprintf(message, size,
                 "there is no window: build/view was not built (it needs GLFW; see README.md). "
                 "Look at pictures instead: make grade LAB=%s ARGS=\"--output wrong\"",
                 rubric->id);
        return;
    }
    if (viewer->pid > 0) {
        snprintf(message, size, "a window is open already; close it first");
        return;
    }
    viewer->log = open_log();
    viewer->pid = viewer->log >= 0 ? fork() : -1;
    if (viewer->pid == 0)
        run(program, rubric->id, is_open ? rubric->checks[board->focus.check].task : "", viewer->log);
    snprintf(message, size, viewer->pid > 0 ? "the window opens" : "the window could not be started");
}

bool viewer_failed(Viewer *viewer, char *message, size_t size) {
    int status;
    if (viewer->pid <= 0 || waitpid(viewer->pid, &status, WNOHANG) != viewer->pid)
        return false;
    const bool failed = !WIFEXITED(status) || WEXITSTATUS(status) != 0;
    if (failed) {
        char words[400] = "";
        ssize_t n = pread(viewer->log, words, sizeof words - 1, 0);
        words[n > 0 ? n : 0] = '\0';
        words[strcspn(words, "\n")] = '\0';
        snprintf(message, size, "the window has ended: %s", words[0] ? words : "it crashed");
    }
    close(viewer->log);
    *viewer = (Viewer){0};
    return failed;
}
