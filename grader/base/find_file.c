#include "base/find_file.h"

#include "base/files.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

typedef struct Hunt {
    const char *name;
    char *found;
    int worth; // of what was found: the larger, the nearer
} Hunt;

// What may stand between "lab" and ".c": " (1)", "(1)", "-1", " 2", " - Copy".
static bool is_added(const char *text, size_t length) {
    size_t digits = 0;
    for (size_t i = 0; i < length; i++) {
        if (isdigit((unsigned char)text[i]))
            digits++;
        else if (!strchr(" ()-_", text[i]))
            return length == strlen(" - Copy") && strncasecmp(text, " - Copy", length) == 0;
    }
    return digits > 0 && digits < 3;
}

static bool is_numbered(const char *name, const char *wanted) {
    const char *end = strrchr(wanted, '.');
    const size_t stem = end ? (size_t)(end - wanted) : strlen(wanted), tail = end ? strlen(end) : 0;
    const size_t length = strlen(name);
    return length > stem + tail && strncasecmp(name, wanted, stem) == 0 &&
           strcasecmp(name + length - tail, end ? end : "") == 0 &&
           is_added(name + stem, length - stem - tail);
}

static int worth(const char *name, const char *wanted) {
    const size_t length = strlen(wanted);
    if (strcmp(name, wanted) == 0)
        return 5;
    if (strcasecmp(name, wanted) == 0)
        return 4;
    if (strncasecmp(name, wanted, length) == 0 && strcasecmp(name + length, ".txt") == 0)
        return 3;
    if (is_numbered(name, wanted))
        return 2;
    return strncasecmp(name, "Copy of ", 8) == 0 && strcasecmp(name + 8, wanted) == 0;
}

static void look(const char *name, void *context) {
    Hunt *hunt = context;
    const int now = worth(name, hunt->name);
    if (now <= hunt->worth || strlen(name) >= FIND_FILE_NAME)
        return;
    hunt->worth = now;
    snprintf(hunt->found, FIND_FILE_NAME, "%s", name);
}

bool find_file(char found[FIND_FILE_NAME], const char *folder, const char *name) {
    Hunt hunt = {.name = name, .found = found};
    files_list(folder, look, &hunt);
    return hunt.worth > 0;
}

char *find_file_read(const char *folder, const char *name, size_t limit) {
    char found[FIND_FILE_NAME];
    return files_read_untrusted(folder, find_file(found, folder, name) ? found : name, limit);
}
