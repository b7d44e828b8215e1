#include "base/text_check.h"

#include "scene/check.h"

#include <string.h>

static bool is_utf16(const char *text, size_t size) {
    const bool marked = size >= 2 && (memcmp(text, "\xff\xfe", 2) == 0 || memcmp(text, "\xfe\xff", 2) == 0);
    return marked || (size >= 4 && ((text[0] == '\0') != (text[1] == '\0')) &&
                      ((text[2] == '\0') != (text[3] == '\0')));
}

// .docx, .xlsx and .odt are zip archives; before them came compound files. Some lists are web pages called
// .xls.
static bool is_document(const char *text, size_t size) {
    static const char *const begins[] = {"PK\x03\x04", "\xd0\xcf\x11\xe0", "{\\rtf", "%PDF", "<?xml",
                                         "<html",      "<!DOCTYPE",        "<table"};
    for (size_t i = 0; i < sizeof begins / sizeof begins[0]; i++)
        if (size >= strlen(begins[i]) && memcmp(text, begins[i], strlen(begins[i])) == 0)
            return true;
    return false;
}

static int line_of(const char *text, size_t at) {
    int line = 1;
    for (size_t i = 0; i < at; i++)
        line += text[i] == '\n';
    return line;
}

bool text_check(char *text, size_t size, const char *name) {
    if (is_utf16(text, size))
        return check_fail("%s is stored as UTF-16: save it as UTF-8", name);
    if (is_document(text, size))
        return check_fail("%s is a document of an office program: save it as plain text (UTF-8)", name);
    const char *zero = memchr(text, '\0', size);
    if (zero)
        return check_fail("%s:%d: there is a byte 0 in the text: save it as plain text (UTF-8)", name,
                          line_of(text, (size_t)(zero - text)));
    if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
        memmove(text, text + 3, size - 2); // with the 0
    for (char *at = strchr(text, '\n') ? NULL : text; at && (at = strchr(at, '\r'));)
        *at = '\n';
    return true;
}
