// jail_unpack: reads an archive on descriptor 0 and tells its files on descriptor 3 (extract_protocol.h), by
// libarchive.
#include "jail/extract_protocol.h"

#include <archive.h>
#include <archive_entry.h>
#include <locale.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { REPLIES = 3 };

static bool transfer(int descriptor, void *data, size_t size, bool sending) {
    for (size_t done = 0; done < size;) {
        char *at = (char *)data + done;
        ssize_t n = sending ? write(descriptor, at, size - done) : read(descriptor, at, size - done);
        if (n <= 0)
            return false;
        done += (size_t)n;
    }
    return true;
}

static void tell(ExtractKind kind, const char *text, void *bytes, size_t size) {
    static ExtractEntry entry;
    memset(&entry, 0, sizeof entry);
    entry.kind = kind;
    entry.size = (uint32_t)size;
    snprintf(entry.text, sizeof entry.text, "%s", text);
    if (!transfer(REPLIES, &entry, sizeof entry, true) || !transfer(REPLIES, bytes, size, true))
        exit(1);
}

static _Noreturn void refuse(const char *text) {
    tell(EXTRACT_REFUSED, text, NULL, 0);
    exit(0);
}

static void tell_file(struct archive *archive, const char *name) {
    static char bytes[EXTRACT_MAX_FILE + 1];
    size_t size = 0;
    la_ssize_t n;
    while (size < sizeof bytes && (n = archive_read_data(archive, bytes + size, sizeof bytes - size)) != 0) {
        if (n < 0)
            refuse(archive_error_string(archive));
        size += (size_t)n;
    }
    tell(EXTRACT_FILE, name, bytes, size);
}

// Its folders and its ending tell whether it may be of a lab.
static bool is_wanted(const char *name) {
    for (const char *slash; (slash = strchr(name, '/')); name = slash + 1)
        if (extract_passes_folder(name, (size_t)(slash - name)) && strncmp(name, "./", 2) != 0 &&
            strncmp(name, "../", 3) != 0 && slash != name)
            return false;
    return name[0] != '.' && extract_wants_file(name);
}

static void tell_entry(struct archive *archive, struct archive_entry *entry) {
    char text[900];
    const char *name = archive_entry_pathname_utf8(entry);
    if (!name)
        name = archive_entry_pathname(entry);
    if (!name || strlen(name) >= sizeof text - 100)
        refuse("it holds a name that is too long or cannot be read");
    if (archive_entry_filetype(entry) == AE_IFDIR || !is_wanted(name))
        return; // a folder is made when a file lies in it
    snprintf(text, sizeof text, "\"%s\" is a link or a device, not a file: hand in the file itself", name);
    if (archive_entry_filetype(entry) != AE_IFREG || archive_entry_hardlink(entry) ||
        archive_entry_symlink(entry))
        refuse(text);
    tell_file(archive, strncmp(name, "./", 2) == 0 ? name + 2 : name);
}

static struct archive *open_archive(void *bytes, size_t size) {
    struct archive *archive = archive_read_new();
    if (archive && archive_read_support_format_zip(archive) == ARCHIVE_OK &&
        archive_read_support_format_tar(archive) == ARCHIVE_OK) {
        archive_read_support_format_7zip(archive);
        archive_read_support_format_rar(archive);
        archive_read_support_format_rar5(archive);
        archive_read_support_filter_gzip(archive);
        archive_read_support_filter_bzip2(archive);
        archive_read_support_filter_xz(archive);
        archive_read_support_filter_zstd(archive);
        if (archive_read_open_memory(archive, bytes, size) == ARCHIVE_OK)
            return archive;
    }
    refuse("it is no .zip, .tar, .7z or .rar archive");
}

int main(void) {
    setlocale(LC_ALL, "");
    uint64_t size;
    if (!transfer(STDIN_FILENO, &size, sizeof size, false) || size > EXTRACT_MAX_ARCHIVE)
        return 2;
    void *bytes = malloc(size + 1);
    if (!bytes || !transfer(STDIN_FILENO, bytes, size, false))
        return 2;
    tell(EXTRACT_READY, "", NULL, 0);
    struct archive *archive = open_archive(bytes, size);
    struct archive_entry *entry;
    int status;
    while ((status = archive_read_next_header(archive, &entry)) == ARCHIVE_OK || status == ARCHIVE_WARN)
        tell_entry(archive, entry);
    if (status != ARCHIVE_EOF)
        refuse(archive_error_string(archive));
    tell(EXTRACT_END, "", NULL, 0);
    archive_read_free(archive);
    free(bytes);
    return 0;
}
