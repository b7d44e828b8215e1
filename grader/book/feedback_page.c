#include "book/feedback_page.h"

#include "base/files.h"
#include "pages/page.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_BYTES = 64 << 20 };

// Removes all from a mark where points begin to where they end. How many there were. What a student wrote
// holds no mark: in it < is escaped.
static int drop_points(char *page) {
    int count = 0;
    for (char *begin = page, *end;
         (begin = strstr(begin, PAGE_POINTS)) && (end = strstr(begin, PAGE_POINTS_END)); count++)
        memmove(begin, end + strlen(PAGE_POINTS_END), strlen(end + strlen(PAGE_POINTS_END)) + 1);
    return count;
}

// Writes the page with another text in its first element `tag`.
static const char *rename_element(FILE *out, const char *page, const char *tag, const char *name) {
    char open[16], close[16];
    snprintf(open, sizeof open, "<%s>", tag);
    snprintf(close, sizeof close, "</%s>", tag);
    const char *begin = strstr(page, open), *end = begin ? strstr(begin, close) : NULL;
    if (!end)
        return page;
    Page escaped = {.out = out};
    fwrite(page, 1, (size_t)(begin - page) + strlen(open), out);
    page_text(&escaped, name);
    return end;
}

static char *renamed(const char *page, const char *name) {
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    INVARIANT(out);
    const char *rest = rename_element(out, page, "title", name);
    rest = rename_element(out, rest, "h1", name);
    fputs(rest, out);
    fclose(out);
    return text;
}

bool feedback_page_copy(const char *path, const char *output, const RosterEntry *entry, const char *name,
                        bool no_points) {
    char from[FILES_PATH], file[ESCAPE_FILE_NAME + 16];
    snprintf(file, sizeof file, "pages/%s.html", entry->file);
    files_join(from, output, file);
    char *page = files_read(from, MOST_BYTES), *text = page;
    if (!page)
        return false;
    bool ok = !no_points || drop_points(page) > 0 ||
              check_fail("%s was made by an older grader and has its points: --only %s grades it again", from,
                         entry->file);
    if (name)
        text = renamed(page, name);
    ok = ok && files_write_whole(path, text, true);
    if (text != page)
        free(text);
    free(page);
    return ok;
}
