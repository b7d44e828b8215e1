// Sends the archive to the unpacker in the jail and writes the files that it tells of, after a look at each
// name and size.
#include "jail/extract.h"

#include "scene/check.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct Extraction {
    Process process;
    int folder; // descriptor
    bool ready; // what goes wrong from now on may be the archive's fault
    int files, folders;
    size_t bytes;
    Extracted result; // of what has failed
} Extraction;

// Only the last fault before the end counts: whoever calls this gives up.
static bool refuse(Extraction *extraction, const char *format, ...) __attribute__((format(printf, 2, 3)));
static bool refuse(Extraction *extraction, const char *format, ...) {
    char text[1200];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    extraction->result = EXTRACT_BAD_ARCHIVE;
    return check_fail("the archive%s", text);
}

// The archive's size and bytes in one block, as the protocol wants them.
static char *read_archive(Extraction *extraction, const char *path, size_t *size) {
    struct stat info;
    char *block = NULL;
    int descriptor = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0)
        check_fail("the archive cannot be read: %s", strerror(errno));
    else if (fstat(descriptor, &info) != 0 || !S_ISREG(info.st_mode))
        refuse(extraction, " is not a file");
    else if (info.st_size > EXTRACT_MAX_ARCHIVE)
        refuse(extraction, " is larger than %d MiB", EXTRACT_MAX_ARCHIVE >> 20);
    else if ((block = calloc((size_t)info.st_size + sizeof(uint64_t), 1))) {
        uint64_t bytes = (uint64_t)info.st_size;
        memcpy(block, &bytes, sizeof bytes);
        *size = sizeof bytes + (size_t)bytes;
        if (pread(descriptor, block + sizeof bytes, (size_t)bytes, 0) != info.st_size) {
            check_fail("the archive cannot be read");
            free(block);
            block = NULL;
        }
    }
    if (descriptor >= 0)
        close(descriptor);
    return block;
}

static bool is_plain(const char *name) {
    bool start = true; // of a component
    for (const char *at = name; *at; at++) {
        size_t length = strcspn(at, "/");
        if ((unsigned char)*at < ' ' || *at == 0x7f)
            return false;
        if (start && (length == 0 || length > 255 || strncmp(at, ".", length) == 0 ||
                      (length == 2 && strncmp(at, "..", 2) == 0)))
            return false;
        start = *at == '/';
    }
    return !start;
}

// False with errno.
static bool make_parents(Extraction *extraction, const char *name) {
    char path[sizeof((ExtractEntry *)0)->text];
    snprintf(path, sizeof path, "%s", name);
    for (char *slash = strchr(path, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        if (mkdirat(extraction->folder, path, 0755) == 0)
            extraction->folders++;
        else if (errno != EEXIST)
            return false;
        *slash = '/';
    }
    return true;
}

static bool is_too_deep(const char *name) {
    int depth = 0;
    for (; *name; name++)
        depth += *name == '/';
    return depth > EXTRACT_MAX_DEPTH;
}

// Is it the name that is wrong, and not our disk?
static bool is_of_name(int error) {
    return error == EEXIST || error == ENOTDIR || error == EISDIR || error == ENAMETOOLONG ||
           error == EINVAL || error == EILSEQ || error == ELOOP;
}

static bool fail_file(Extraction *extraction, const char *name, int error) {
    if (is_of_name(error))
        return refuse(extraction, ": \"%s\" cannot be made: %s", name, strerror(error));
    return check_fail("\"%s\" of the archive cannot be written: %s", name, strerror(error));
}

// All below the folder is made by us, and we make no links: so a name cannot lead out of it. Of a name that
// comes twice the last counts, as for tar.
static bool write_file(Extraction *extraction, const char *name, const char *bytes, size_t size) {
    if (!make_parents(extraction, name))
        return fail_file(extraction, name, errno);
    if (unlinkat(extraction->folder, name, 0) != 0 && errno != ENOENT)
        return fail_file(extraction, name, errno);
    int file = openat(extraction->folder, name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
    if (file < 0)
        return fail_file(extraction, name, errno);
    ssize_t written = write(file, bytes, size);
    int error = written < 0 ? errno : ENOSPC;
    bool ok = close(file) == 0 && written == (ssize_t)size;
    return ok || check_fail("\"%s\" of the archive cannot be written: %s", name, strerror(error));
}

static bool take_file(Extraction *extraction, const ExtractEntry *entry) {
    extraction->bytes += entry->size;
    if (!is_plain(entry->text))
        return refuse(extraction, " holds a file with a path that leads out of it or is no plain name");
    if (entry->size > EXTRACT_MAX_FILE || extraction->bytes > EXTRACT_MAX_BYTES)
        return refuse(extraction, " holds more than %d MiB in one file or %d MiB in all",
                      EXTRACT_MAX_FILE >> 20, EXTRACT_MAX_BYTES >> 20);
    if (++extraction->files > EXTRACT_MAX_FILES || extraction->folders > EXTRACT_MAX_FOLDERS)
        return refuse(extraction, " holds more than %d files of a lab's kind or %d folders",
                      EXTRACT_MAX_FILES, EXTRACT_MAX_FOLDERS);
    if (is_too_deep(entry->text))
        return refuse(extraction, " holds a file below more than %d folders", EXTRACT_MAX_DEPTH);
    char *bytes = malloc(entry->size + 1);
    bool ok = bytes && (process_exchange(&extraction->process, NULL, 0, bytes, entry->size) ||
                        refuse(extraction, ": the unpacker ended too early"));
    ok = ok && write_file(extraction, entry->text, bytes, entry->size);
    free(bytes);
    return ok;
}

// The unpacker, which a bad archive may have broken, has ended before it told the end.
static bool explain_break(Extraction *extraction) {
    const Process *process = &extraction->process;
    if (!extraction->ready || process->state == PROCESS_DEAF)
        return check_fail("the unpacker does not start: %.200s", process->text);
    if (process->state == PROCESS_TIMED_OUT)
        return refuse(extraction, " takes too long to unpack");
    return refuse(extraction, ": the unpacker broke off; is it a bomb? %.200s", process->text);
}

static bool take_files(Extraction *extraction, const char *block, size_t size) {
    static ExtractEntry entry;
    for (;;) {
        if (!process_exchange(&extraction->process, block, size, &entry, sizeof entry))
            return explain_break(extraction);
        size = 0;
        entry.text[sizeof entry.text - 1] = '\0';
        if (entry.kind == EXTRACT_END)
            return true;
        if (entry.kind == EXTRACT_READY) {
            extraction->ready = true;
            continue;
        }
        if (entry.kind != EXTRACT_FILE)
            return refuse(extraction, ": %.900s", entry.text);
        if (!take_file(extraction, &entry))
            return false;
    }
}

Extracted jail_extract(const Jail *jail, const char *archive, const char *folder) {
    static Extraction extraction;
    extraction = (Extraction){.result = EXTRACT_FAULT};
    char unpacker[FILES_PATH];
    size_t size = 0;
    char *block = read_archive(&extraction, archive, &size);
    if (!block)
        return extraction.result;
    extraction.folder = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    jail_part(jail, "jail_unpack", unpacker);
    char *arguments[] = {unpacker, NULL}, *environment[] = {"LC_ALL=C.UTF-8", NULL};
    JailPlan plan = {.kind = JAIL_DRAW,
                     .limits = {.wall_seconds = 20, .cpu_seconds = 10, .memory_mib = 1024, .file_mib = 1},
                     .folder = jail ? jail->stage : "/"};
    bool ok = extraction.folder >= 0 || check_fail("%s cannot be opened: %s", folder, strerror(errno));
    ok = ok && jail_start(jail, &plan, &extraction.process, arguments, environment) &&
         take_files(&extraction, block, size);
    process_stop(&extraction.process);
    if (extraction.folder >= 0)
        close(extraction.folder);
    free(block);
    return ok ? EXTRACT_OK : extraction.result;
}
