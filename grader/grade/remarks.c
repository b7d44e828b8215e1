#include "grade/remarks.h"

#include "scene/check.h"

#include <stdio.h>
#include <string.h>

static void take_line(Remarks *remarks, const char *line) {
    int i = 0;
    while (i < REMARKS_MAX && remarks->lines[i][0] && strcmp(remarks->lines[i], line) != 0)
        i++;
    if (i == REMARKS_MAX || !line[0])
        return;
    snprintf(remarks->lines[i], sizeof remarks->lines[i], "%s", line);
    remarks->frames[i]++;
}

void remarks_take(Remarks *remarks, const char *text) {
    char line[sizeof remarks->lines[0]];
    remarks->all++;
    while (*text) {
        const size_t length = strcspn(text, "\n");
        snprintf(line, sizeof line, "%.*s", length < sizeof line ? (int)length : (int)sizeof line - 1, text);
        take_line(remarks, line);
        text += length + (text[length] == '\n');
    }
}

void remarks_write(const Remarks *remarks, char *text, size_t size) {
    text[0] = '\0';
    for (int i = 0; i < REMARKS_MAX && remarks->lines[i][0]; i++)
        if (remarks->frames[i] == remarks->all)
            check_append(text, size, "%s" REMARK "%s", text[0] ? "\n" : "", remarks->lines[i]);
}
