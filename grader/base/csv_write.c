#include "base/csv_write.h"

#include "scene/count.h"

#include <string.h>

bool csv_is_formula(const char *text) {
    static const char *const begins[] = {"=", "+", "-", "@", "'", "\uff1d", "\uff0b", "\uff0d", "\uff20"};
    if (strcmp(text, "-") == 0) // "nothing", in many lists
        return false;
    for (size_t i = 0; i < COUNT(begins); i++)
        if (strncmp(text, begins[i], strlen(begins[i])) == 0)
            return true;
    return false;
}

void csv_write_cell(FILE *out, const char *text) {
    fputs(csv_is_formula(text) ? "\"'" : "\"", out);
    for (; *text && *text != '\n'; text++)
        fputs(*text == '"' ? "\"\"" : (char[2]){*text, '\0'}, out);
    fputc('"', out);
}
