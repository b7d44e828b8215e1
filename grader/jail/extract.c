#include "jail/extract.h"

#include "scene/check.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct Extraction {
    Process process;
    const char *archive;
    int folder; // descriptor
    int files;
    size_t bytes;
} Extraction;

// The archive's size and bytes in one block, as the protocol wants them.
static char *read_archive(const char *path, size_t *size) {
    struct stat info;
    char *block = NULL;
    int descriptor = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0 || fstat(descriptor, &info) != 0 || !S_ISREG(info.st_mode))
        check_fail("%s is not a file that can be read", path);
    else if (info.st_size > EXTRACT_MAX_ARCHIVE)
        check_fail("%s is larger than %d MiB", path, EXTRACT_MAX_ARCHIVE >> 20);
    else if ((block = calloc((size_t)info.st_size + sizeof(uint64_t), 1))) {
        uint64_t bytes = (uint64_t)info.st_size;
        memcpy(block, &bytes, sizeof bytes);
        *size = sizeof bytes + (size_t)bytes;
        if (pread(descriptor, block + sizeof bytes, (size_t)bytes, 0) != info.st_size) {
            check_fail("%s cannot be read", path);
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

static bool make_parents(int folder, const char *name) {
    char path[sizeof((ExtractEntry *)0)->text];
    snprintf(path, sizeof path, "%s", name);
    for (char *slash = strchr(path, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        if (mkdirat(folder, path, 0755) != 0 && errno != EEXIST)
            return false;
        *slash = '/';
    }
    return true;
}

// All below the folder is made by us, and we make no links: so a name cannot lead out of it.
static bool write_file(const Extraction *extraction, const char *name, const char *bytes, size_t size) {
    if (!make_parents(extraction->folder, name))
        return check_fail("%s: a folder for \"%s\" cannot be made: %s", extraction->archive, name,
                          strerror(errno));
    int file = openat(extraction->folder, name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
    if (file < 0)
        return check_fail(errno == EEXIST ? "%s holds \"%s\" twice" : "%s: \"%s\" cannot be made: %s",
                          extraction->archive, name, strerror(errno));
    bool ok = write(file, bytes, size) == (ssize_t)size;
    ok = close(file) == 0 && ok;
    return ok || check_fail("%s: \"%s\" cannot be written: %s", extraction->archive, name, strerror(errno));
}

static bool take_file(Extraction *extraction, const ExtractEntry *entry) {
    const char *archive = extraction->archive;
    extraction->bytes += entry->size;
    if (!is_plain(entry->text))
        return check_fail("%s holds a file with a path that leads out of it or is no plain name", archive);
    if (entry->size > EXTRACT_MAX_FILE || extraction->bytes > EXTRACT_MAX_BYTES)
        return check_fail("%s holds more than %d MiB in one file or %d MiB in all", archive,
                          EXTRACT_MAX_FILE >> 20, EXTRACT_MAX_BYTES >> 20);
    if (++extraction->files > EXTRACT_MAX_FILES)
        return check_fail("%s holds more than %d files", archive, EXTRACT_MAX_FILES);
    char *bytes = malloc(entry->size + 1);
    bool ok = bytes && (process_exchange(&extraction->process, NULL, 0, bytes, entry->size) ||
                        check_fail("%s: the unpacker ended too early", archive));
    ok = ok && write_file(extraction, entry->text, bytes, entry->size);
    free(bytes);
    return ok;
}

static bool take_files(Extraction *extraction, const char *block, size_t size) {
    static ExtractEntry entry;
    Process *process = &extraction->process;
    for (;;) {
        if (!process_exchange(process, block, size, &entry, sizeof entry))
            return check_fail(process->state == PROCESS_TIMED_OUT
                                  ? "%s takes too long to unpack"
                                  : "%s: the unpacker broke off; is it a bomb? %.200s",
                              extraction->archive, process->text);
        size = 0;
        entry.text[sizeof entry.text - 1] = '\0';
        if (entry.kind == EXTRACT_END)
            return true;
        if (entry.kind != EXTRACT_FILE)
            return check_fail("%s: %.900s", extraction->archive, entry.text);
        if (!take_file(extraction, &entry))
            return false;
    }
}

bool jail_extract(const Jail *jail, const char *archive, const char *folder) {
    static Extraction extraction;
    extraction = (Extraction){.archive = archive};
    char unpacker[FILES_PATH];
    size_t size = 0;
    char *block = read_archive(archive, &size);
    if (!block)
        return false;
    extraction.folder = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    jail_part(jail, "jail_unpack", unpacker);
    char *arguments[] = {unpacker, NULL}, *environment[] = {"LC_ALL=C.UTF-8", NULL};
    JailPlan plan = {.kind = JAIL_DRAW,
                     .limits = {.wall_seconds = 20, .cpu_seconds = 10, .memory_mib = 1024, .file_mib = 1},
                     .folder = jail->stage};
    bool ok = extraction.folder >= 0 || check_fail("%s cannot be opened: %s", folder, strerror(errno));
    ok = ok && jail_start(jail, &plan, &extraction.process, arguments, environment) &&
         take_files(&extraction, block, size);
    process_stop(&extraction.process);
    if (extraction.folder >= 0)
        close(extraction.folder);
    free(block);
    return ok;
}
