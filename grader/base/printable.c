// Reads UTF-8 strictly and writes every other byte as \xNN, so that each text stands for one name; and back.
#include "base/printable.h"

#include "base/hash.h"
#include "scene/check.h"
#include "scene/count.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { READABLE = 24 };

// Length of the UTF-8 sequence at `bytes` (RFC 3629: no overlong forms, no surrogates), 0 when there is none.
static int sequence(const unsigned char *bytes, uint32_t *code) {
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    int length = bytes[0] < 0x80       ? 1
                 : bytes[0] >> 5 == 6  ? 2
                 : bytes[0] >> 4 == 14 ? 3
                 : bytes[0] >> 3 == 30 ? 4
                                       : 0;
    if (length < 2) {
        *code = bytes[0];
        return length;
    }
    *code = bytes[0] & (0x7fu >> length);
    for (int i = 1; i < length; i++) {
        if (bytes[i] >> 6 != 2)
            return 0;
        *code = *code << 6 | (bytes[i] & 0x3f);
    }
    bool valid = *code >= least[length] && *code <= 0x10ffff && (*code < 0xd800 || *code > 0xdfff);
    return valid ? length : 0;
}

static bool is_among(uint32_t code, const uint32_t (*ranges)[2], size_t count) {
    for (size_t i = 0; i < count; i++)
        if (code >= ranges[i][0] && code <= ranges[i][1])
            return true;
    return false;
}

// Can a person see the character, where it stands?
static bool is_printable(uint32_t code) {
    static const uint32_t hidden[][2] = {{0, 0x1f},        {0x7f, 0x9f},     {0xad, 0xad},
                                         {0x61c, 0x61c},   {0x180e, 0x180e}, {0x200b, 0x200f},
                                         {0x2028, 0x202e}, {0x2060, 0x206f}, {0xfeff, 0xfeff},
                                         {0xfff9, 0xfffb}, {0xfffe, 0xffff}, {0xe0000, 0x10ffff}};
    return !is_among(code, hidden, COUNT(hidden));
}

char *printable_name(const char *bytes) {
    char *text = malloc(4 * strlen(bytes) + 1), *to = text;
    INVARIANT(text);
    while (*bytes) {
        uint32_t code;
        int length = sequence((const unsigned char *)bytes, &code);
        if (length > 0 && is_printable(code)) {
            if (code == '\\')
                *to++ = '\\';
            memcpy(to, bytes, (size_t)length);
            to += length;
        } else {
            length = length > 0 ? length : 1;
            for (int i = 0; i < length; i++)
                to += sprintf(to, "\\x%02x", (unsigned char)bytes[i]);
        }
        bytes += length;
    }
    *to = '\0';
    return text;
}

char *printable_undo(const char *text) {
    char *bytes = malloc(strlen(text) + 1), *to = bytes;
    INVARIANT(bytes);
    for (unsigned value; *text; to++) {
        if (text[0] != '\\') {
            *to = *text++;
        } else if (text[1] == '\\') {
            *to = '\\';
            text += 2;
        } else if (text[1] == 'x' && isxdigit((unsigned char)text[2]) && isxdigit((unsigned char)text[3]) &&
                   sscanf(text + 2, "%2x", &value) == 1 && value > 0) {
            *to = (char)value;
            text += 4;
        } else {
            free(bytes);
            return NULL;
        }
    }
    *to = '\0';
    return bytes;
}

void printable_file_name(char file[ESCAPE_FILE_NAME], const char *bytes) {
    uint64_t hash = hash_bytes(HASH_START, bytes, strlen(bytes));
    int length = 0;
    for (const char *at = bytes; *at; at++)
        if (isalnum((unsigned char)*at) && (unsigned char)*at < 0x80 && length < READABLE)
            file[length++] = *at;
    snprintf(file + length, ESCAPE_FILE_NAME - (size_t)length, "-%016llx", (unsigned long long)hash);
    if (length == 0)
        file[0] = '_';
}

size_t printable_utf8(const char *text) {
    const char *at = text;
    uint32_t code;
    for (int length = 1; *at && length > 0; at += length)
        length = sequence((const unsigned char *)at, &code);
    return (size_t)(at - text);
}

// After Unicode's EastAsianWidth.txt and the marks (Mn) of the scripts that names are written in.
static int columns_of(uint32_t code) {
    static const uint32_t none[][2] = {{0x300, 0x36f},   {0x483, 0x489},   {0x591, 0x5bd},   {0x610, 0x61a},
                                       {0x64b, 0x65f},   {0x200b, 0x200f}, {0x20d0, 0x20f0}, {0xfe00, 0xfe0f},
                                       {0xfe20, 0xfe2f}, {0xfeff, 0xfeff}};
    static const uint32_t two[][2] = {
        {0x1100, 0x115f},   {0x231a, 0x231b},   {0x2e80, 0x303e},  {0x3041, 0xa4cf}, {0xac00, 0xd7a3},
        {0xf900, 0xfaff},   {0xfe30, 0xfe6f},   {0xff01, 0xff60},  {0xffe0, 0xffe6}, {0x1f300, 0x1f64f},
        {0x1f680, 0x1f6ff}, {0x1f900, 0x1f9ff}, {0x20000, 0x3fffd}};
    return is_among(code, none, COUNT(none)) ? 0 : is_among(code, two, COUNT(two)) ? 2 : 1;
}

size_t printable_clip(const char *text, int columns) {
    const char *at = text;
    while (*at) {
        uint32_t code;
        int length = sequence((const unsigned char *)at, &code);
        columns -= length > 0 ? columns_of(code) : 1; // what is no UTF-8 shows as a sign of its own
        if (columns < 0)
            break;
        at += length > 0 ? length : 1;
    }
    return (size_t)(at - text);
}

int printable_columns(const char *text) {
    int columns = 0;
    while (text[printable_clip(text, columns)])
        columns++;
    return columns;
}
