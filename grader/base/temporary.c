#include "base/temporary.h"

#include "scene/count.h"

#include <limits.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { MAX_FOLDERS = 8 };

// "rm", "-rf", "--", the folders, NULL: what the signal handler needs is ready before.
static char folders[MAX_FOLDERS][PATH_MAX];
static char *command[MAX_FOLDERS + 4] = {"rm", "-rf", "--"};
static pid_t owner; // who noted the folders

static void list_folders(void) {
    int count = 3;
    for (int i = 0; i < MAX_FOLDERS; i++)
        if (folders[i][0])
            command[count++] = folders[i];
    command[count] = NULL;
}

static void replace(const char *from, const char *to) {
    int i = 0;
    while (i < MAX_FOLDERS && strcmp(folders[i], from) != 0)
        i++;
    if (i < MAX_FOLDERS)
        snprintf(folders[i], sizeof folders[i], "%s", to);
    list_folders();
}

// Those who still write to the folders die with us; so our child waits for our death and then removes them.
static void end(int number) {
    pid_t parent = getpid();
    if (command[3] && owner == parent && _Fork() == 0) {
        setsid();
        while (getppid() == parent)
            usleep(1000);
        usleep(20 * 1000);
        execv("/bin/rm", command);
        _exit(127);
    }
    signal(number, SIG_DFL);
    raise(number);
}

static void watch_signals(void) {
    static const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
    for (unsigned i = 0; i < COUNT(numbers); i++) {
        struct sigaction before;
        if (sigaction(numbers[i], NULL, &before) == 0 && before.sa_handler == SIG_DFL)
            sigaction(numbers[i], &(struct sigaction){.sa_handler = end}, NULL);
    }
}

void temporary_add(const char *folder) {
    if (owner != getpid())
        memset(folders, 0, sizeof folders); // those of the parent, which needs them
    owner = getpid();
    replace("", folder);
    watch_signals();
}

void temporary_drop(const char *folder) {
    replace(folder, "");
}
