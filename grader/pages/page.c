#include "pages/page.h"

#include "scene/check.h"
#include "base/files.h"
#include "base/places.h"

#include <stdlib.h>

enum { MAX_PART = 64 * 1024 };

static bool include(Page *page, const char *name) {
    char path[FILES_PATH];
    places_path(path, name);
    char *text = files_read(path, MAX_PART);
    if (text)
        fputs(text, page->out);
    free(text);
    return text != NULL;
}

bool page_begin(Page *page, const char *title) {
    *page = (Page){0};
    page->out = open_memstream(&page->text, &page->size);
    if (!page->out)
        return check_fail("out of memory");
    fputs("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
          "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
          "'unsafe-inline'; "
          "script-src 'unsafe-inline'; img-src data:\">\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>",
          page->out);
    page_text(page, title);
    fputs("</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n", page->out);
    if (!include(page, "grader/pages/page.css")) {
        free(page_end(page));
        return false;
    }
    fputs("</style>\n</head>\n<body>\n<main>\n<h1>", page->out);
    page_text(page, title);
    fputs("</h1>\n", page->out);
    return true;
}

char *page_end(Page *page) {
    fputs("</main>\n<script>\n", page->out);
    bool ok = include(page, "grader/pages/page.js");
    fputs("</script>\n</body>\n</html>\n", page->out);
    ok = fclose(page->out) == 0 && ok;
    char *text = page->text;
    *page = (Page){0};
    if (ok)
        return text;
    free(text);
    check_fail("out of memory");
    return NULL;
}

void page_text(Page *page, const char *text) {
    for (; *text; text++)
        switch (*text) {
        case '<':
            fputs("&lt;", page->out);
            break;
        case '>':
            fputs("&gt;", page->out);
            break;
        case '&':
            fputs("&amp;", page->out);
            break;
        case '"':
            fputs("&quot;", page->out);
            break;
        case '\'':
            fputs("&#39;", page->out);
            break;
        default:
            fputc(*text, page->out);
        }
}

void page_base64(FILE *out, const uint8_t *bytes, size_t size) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < size; i += 3) {
        unsigned group = (unsigned)bytes[i] << 16;
        group |= i + 1 < size ? (unsigned)bytes[i + 1] << 8 : 0;
        group |= i + 2 < size ? bytes[i + 2] : 0;
        fputc(digits[group >> 18], out);
        fputc(digits[group >> 12 & 63], out);
        fputc(i + 1 < size ? digits[group >> 6 & 63] : '=', out);
        fputc(i + 2 < size ? digits[group & 63] : '=', out);
    }
}

void page_data(Page *page, const char *type, const void *bytes, size_t size) {
    fprintf(page->out, "data:%s;base64,", type);
    page_base64(page->out, bytes, size);
}

void page_picture(Page *page, const Image *image, const char *class_name, const char *description) {
    size_t size;
    uint8_t *png = image_encode_png(image, false, &size);
    fprintf(page->out, "<img class=\"%s\" width=\"%d\" height=\"%d\" alt=\"", class_name, image->width,
            image->height);
    page_text(page, description);
    fputs("\" src=\"", page->out);
    if (png)
        page_data(page, "image/png", png, size);
    fputs("\">", page->out);
    free(png);
}
