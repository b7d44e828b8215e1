#include "base/memory.h"

#include <ctype.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct Sum {
    bool seen; // at least one of the group, be it dead already
    long pages;
} Sum;

// Adds the resident pages of a process of this group.
static void add_process(Sum *sum, const char *pid, pid_t group) {
    char path[64], text[1024] = "";
    int its_group = 0;
    long pages = 0;
    snprintf(path, sizeof path, "/proc/%.20s/stat", pid);
    FILE *file = fopen(path, "r");
    if (!file)
        return;
    const size_t length = fread(text, 1, sizeof text - 1, file);
    fclose(file);
    text[length] = '\0';
    // PID (NAME) STATE PARENT GROUP ... with the pages as field 24; a name may hold anything.
    const char *rest = strrchr(text, ')');
    if (!rest ||
        sscanf(rest + 1,
               " %*c %*d %d %*d %*d %*d %*u %*u %*u %*u %*u %*u %*u %*d %*d %*d %*d %*d %*d %*u %*u %ld",
               &its_group, &pages) != 2)
        return;
    if (its_group == group || atoi(pid) == group) { // which it may found in a moment
        sum->seen = true;
        sum->pages += pages;
    }
}

bool memory_within(pid_t group, unsigned mib) {
    Sum sum = {0};
    DIR *folder = opendir("/proc");
    if (!folder)
        return false;
    for (struct dirent *entry; (entry = readdir(folder));)
        if (isdigit((unsigned char)entry->d_name[0]))
            add_process(&sum, entry->d_name, group);
    closedir(folder);
    return sum.seen && sum.pages / 256 * (sysconf(_SC_PAGESIZE) / 4096) <= (long)mib;
}
