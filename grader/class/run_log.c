#include "class/run_log.h"

#include "base/files.h"

#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <sys/file.h>
#include <time.h>
#include <unistd.h>

enum { LINE = 1200 };

static int open_log(const char *output) {
    char path[FILES_PATH];
    files_join(path, output, "log");
    return open(path, O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, 0644);
}

void run_log(const char *output, const char *format, ...) {
    char line[LINE];
    struct tm parts;
    const time_t now = time(NULL);
    size_t length = localtime_r(&now, &parts) ? strftime(line, sizeof line, "%Y-%m-%d %H:%M:%S ", &parts) : 0;
    va_list arguments;
    va_start(arguments, format);
    length += (size_t)vsnprintf(line + length, sizeof line - length - 1, format, arguments);
    va_end(arguments);
    length = length < sizeof line - 1 ? length : sizeof line - 2;
    line[length] = '\n';
    const int log = open_log(output);
    if (log < 0)
        return;
    const ssize_t written = write(log, line, length + 1); // in one piece, also when several processes write
    (void)written;
    close(log);
}

int run_log_enter(const char *output) {
    const int log = open_log(output);
    if (log >= 0)
        flock(log, LOCK_EX);
    return log;
}

void run_log_leave(int descriptor) {
    if (descriptor >= 0)
        close(descriptor);
}
