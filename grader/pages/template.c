#include "pages/template.h"

#include "base/files.h"
#include "base/places.h"

#include <stdlib.h>
#include <string.h>

enum { MAX_FILE = 1 << 20 };

bool template_open(Template *template, const char *file) {
    char path[FILES_PATH];
    places_path(path, file);
    *template = (Template){.text = files_read(path, MAX_FILE)};
    template->rest = template->text;
    return template->text != NULL;
}

const char *template_next(Template *template, FILE *out) {
    const char *open = strstr(template->rest, "{{"), *close = open ? strstr(open, "}}") : NULL;
    size_t before = close ? (size_t)(open - template->rest) : strlen(template->rest);
    if (out)
        fwrite(template->rest, 1, before, out);
    template->rest = close ? close + 2 : template->rest + before;
    if (!close)
        return NULL;
    snprintf(template->hole, sizeof template->hole, "%.*s", (int)(close - open - 2), open + 2);
    return template->hole;
}

void template_close(Template *template) {
    free(template->text);
    *template = (Template){0};
}

bool template_copy(FILE *out, const char *file) {
    Template template;
    if (!template_open(&template, file))
        return false;
    fputs(template.text, out);
    template_close(&template);
    return true;
}
