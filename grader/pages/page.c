// Puts a page together in memory from shell.html and page.css: text is escaped, pictures are written into it.
#include "pages/page.h"

#include "scene/check.h"
#include "pages/template.h"

#include <stdlib.h>
#include <string.h>

static const char shell[] = "grader/pages/shell.html",
                  script_policy[] = "script-src 'unsafe-inline'; img-src data:";

static void write_escaped(FILE *out, const char *text, size_t length) {
    for (const char *end = text + length; text < end; text++)
        switch (*text) {
        case '<':
            fputs("&lt;", out);
            break;
        case '>':
            fputs("&gt;", out);
            break;
        case '&':
            fputs("&amp;", out);
            break;
        case '"':
            fputs("&quot;", out);
            break;
        case '\'':
            fputs("&#39;", out);
            break;
        default:
            fputc(*text, out);
        }
}

bool page_begin_shell(FILE *out, const char *title, const char *style) {
    Template template;
    const char *hole;
    bool ok = template_open(&template, shell);
    while (ok && (hole = template_next(&template, out)) && strcmp(hole, "content") != 0)
        if (strcmp(hole, "policy") == 0)
            fputs(script_policy, out);
        else if (strcmp(hole, "title") == 0)
            write_escaped(out, title, strlen(title));
        else if (strcmp(hole, "style") == 0)
            ok = template_copy(out, "grader/pages/base.css") && template_copy(out, style);
        else
            ok = check_fail("%s: unknown hole {{%s}}; restore the file", shell, hole);
    template_close(&template);
    return ok;
}

bool page_end_shell(FILE *out) {
    Template template;
    const char *hole = "";
    bool ok = template_open(&template, shell);
    while (ok && hole && strcmp(hole, "content") != 0)
        hole = template_next(&template, NULL);
    if (ok)
        template_next(&template, out);
    template_close(&template);
    return ok;
}

bool page_begin(Page *page, const char *title) {
    *page = (Page){0};
    page->out = open_memstream(&page->text, &page->size);
    if (!page->out)
        return check_fail("out of memory");
    if (!page_begin_shell(page->out, title, "grader/pages/page.css")) {
        free(page_end(page));
        return false;
    }
    fputs("<main>\n<h1>", page->out);
    page_text(page, title);
    fputs("</h1>\n", page->out);
    return true;
}

char *page_end(Page *page) {
    fputs("</main>\n<script>\n", page->out);
    bool ok = template_copy(page->out, "grader/pages/compare.js") &&
              template_copy(page->out, "grader/pages/page.js");
    fputs("</script>\n", page->out);
    ok = page_end_shell(page->out) && ok;
    ok = (fclose(page->out) == 0 || check_fail("out of memory")) && ok;
    char *text = page->text;
    *page = (Page){0};
    if (ok)
        return text;
    free(text);
    return NULL;
}

void page_text(Page *page, const char *text) {
    write_escaped(page->out, text, strlen(text));
}

void page_prose(Page *page, const char *text) {
    const char *open, *close;
    while ((open = strchr(text, '`')) && (close = strchr(open + 1, '`'))) {
        write_escaped(page->out, text, (size_t)(open - text));
        fputs("<code>", page->out);
        write_escaped(page->out, open + 1, (size_t)(close - open - 1));
        fputs("</code>", page->out);
        text = close + 1;
    }
    page_text(page, text);
}

static void write_head(Page *page, const char *head) {
    bool number = head[0] == '#';
    const bool points = strcmp(head, "#points") == 0;
    fputs(points ? PAGE_POINTS : "", page->out);
    fputs(number    ? "<th scope=\"col\" class=\"number\">"
          : head[0] ? "<th scope=\"col\">"
                    : "<td>",
          page->out);
    page_text(page, head + number);
    fputs(head[0] ? "</th>" : "</td>", page->out);
    fputs(points ? PAGE_POINTS_END : "", page->out);
}

void page_begin_table(Page *page, const char *label, const char *const *heads) {
    fputs("<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"", page->out);
    page_text(page, label);
    fputs("\"><table><thead><tr>", page->out);
    for (; *heads; heads++)
        write_head(page, *heads);
    fputs("</tr></thead><tbody>\n", page->out);
}

void page_end_table(Page *page) {
    fputs("</tbody></table></div>\n", page->out);
}

void page_cell(Page *page, const char *text) {
    fputs("<td>", page->out);
    page_text(page, text);
    fputs("</td>", page->out);
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
