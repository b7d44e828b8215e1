// Takes predictions.txt apart, line by line. A line is a word and what follows it; # begins a comment.
#include "predict/prediction_file.h"

#include "scene/check.h"
#include "scene/count.h"

#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_WORD = 40, MAX_SHEET = 999999 };

typedef struct Typed {
    char word[MAX_WORD], value[MAX_WORD];
    bool cut; // the value is longer than any number
} Typed;

typedef struct Seen {
    PredictionFile *file;
    bool sheet, entry[RUBRIC_MAX_PREDICTIONS];
} Seen;

// What keyboards and office programs write for a space and for a minus.
static const char *const spaces[] = {" ", "\t", "\r", "=", ":", "\u00a0", "\u2007", "\u2009", "\u202f"};
static const char *const dashes[] = {"\u2212", "\u2010", "\u2011", "\u2013", "\u2014"};

// The length of the one of `texts` that stands at `at`; 0: none does.
static size_t length_at(const char *const *texts, size_t count, const char *at, const char *end) {
    for (size_t i = 0; i < count; i++) {
        const size_t length = strlen(texts[i]);
        if ((size_t)(end - at) >= length && memcmp(at, texts[i], length) == 0)
            return length;
    }
    return 0;
}

static size_t gap_at(const char *at, const char *end) {
    return length_at(spaces, COUNT(spaces), at, end);
}

static const char *after_gaps(const char *at, const char *end) {
    for (size_t gap; at < end && (gap = gap_at(at, end)) > 0;)
        at += gap;
    return at;
}

// Where the text before `end` stops, without the gaps at its end.
static const char *last_of(const char *at, const char *end) {
    const char *last = at;
    for (size_t gap; at < end; at += gap ? gap : 1, last = gap ? last : at)
        gap = gap_at(at, end);
    return last;
}

// Copies what can be printed; the rest becomes "?" or, for bytes of UTF-8 after the first, nothing.
static void copy(char *to, size_t size, const char *from, size_t length) {
    size_t n = 0;
    for (const char *end = from + length; from < end && n + 1 < size; from++) {
        const size_t dash = length_at(dashes, COUNT(dashes), from, end);
        if (dash > 0)
            to[n++] = '-';
        else if (((unsigned char)*from & 0xc0) != 0x80)
            to[n++] = *from >= ' ' && *from < 0x7f ? *from : '?';
    }
    to[n] = '\0';
}

static Typed split(const char *line, size_t length) {
    Typed typed = {0};
    const char *comment = memchr(line, '#', length);
    const char *word = after_gaps(line, comment ? comment : line + length);
    const char *end = last_of(word, comment ? comment : line + length);
    for (line = word; line < end && !gap_at(line, end);)
        line++;
    copy(typed.word, sizeof typed.word, word, (size_t)(line - word));
    line = after_gaps(line, end);
    typed.cut = end - line >= MAX_WORD;
    copy(typed.value, sizeof typed.value, line, (size_t)(end - line));
    return typed;
}

// "b", "B", "b)" and "03.b" are the second; -1 for other words.
static int index_of(const char *word, int entries) {
    const char *dot = strrchr(word, '.');
    const char *letter =
        dot && dot[1] && strspn(word, "0123456789.") == (size_t)(dot + 1 - word) ? dot + 1 : word;
    const int n = tolower((unsigned char)letter[0]) - 'a';
    const bool alone = !letter[1] || (strchr(").", letter[1]) && !letter[2]);
    return letter[0] && alone && n >= 0 && n < entries ? n : -1;
}

static void read_sheet(Seen *seen, const Typed *typed) {
    PredictionFile *file = seen->file;
    char *end;
    const long sheet = strtol(typed->value, &end, 10);
    if (seen->sheet)
        snprintf(file->message, sizeof file->message, "the line `sheet` stands there twice; remove one");
    else if (strspn(typed->value, "?") == strlen(typed->value))
        file->sheet = 0;
    else if (typed->cut || *end || !isdigit((unsigned char)typed->value[0]) || sheet < 1 || sheet > MAX_SHEET)
        snprintf(file->message, sizeof file->message,
                 "sheet %s is no number from 1 to %d; leave this line as it was drawn", typed->value,
                 MAX_SHEET);
    else
        file->sheet = sheet;
    seen->sheet = true;
}

// What is wrong with a value that is no number as we write it. `plain`: so much of it could be one.
static void refuse(PredictionEntry *entry, const Typed *typed, size_t plain) {
    const char *value = typed->value;
    if (typed->cut)
        snprintf(entry->why, sizeof entry->why, "that is too long for a number; four digits are enough");
    else if (strchr(value, ','))
        snprintf(entry->why, sizeof entry->why, "write \"%s\" with a point and without a comma: 0.25, 1250",
                 value);
    else if (plain > 0 && value[plain] && isdigit((unsigned char)value[strcspn(value, "0123456789")]))
        snprintf(entry->why, sizeof entry->why,
                 "write only the number, worked out, and no unit: \"%s\" has \"%s\" in it", value,
                 value + plain);
    else
        snprintf(entry->why, sizeof entry->why, "\"%s\" is no number; write it as 0.25 or 2.5e-3", value);
}

static void read_entry(Seen *seen, int n, const Typed *typed) {
    PredictionEntry *entry = &seen->file->entry[n];
    char *end;
    if (seen->entry[n]) {
        snprintf(entry->why, sizeof entry->why, "%c stands there twice; remove one", 'a' + n);
        return;
    }
    seen->entry[n] = true;
    if (strspn(typed->value, "?") == strlen(typed->value))
        return;
    snprintf(entry->typed, sizeof entry->typed, "%.*s", PREDICTION_NUMBER - 1, typed->value);
    const size_t plain = strspn(typed->value, "+-.0123456789eE");
    entry->value = strtod(typed->value, &end);
    if (typed->cut || typed->value[plain] || *end || end == typed->value)
        refuse(entry, typed, plain);
    else if (!isfinite(entry->value))
        snprintf(entry->why, sizeof entry->why, "%s is beyond all numbers", typed->value);
    else
        entry->why[0] = '\0';
}

static void read_line(Seen *seen, const char *line, size_t length) {
    const Typed typed = split(line, length);
    PredictionFile *file = seen->file;
    const int n = index_of(typed.word, file->entries);
    if (strcmp(typed.word, "sheet") == 0)
        read_sheet(seen, &typed);
    else if (n >= 0)
        read_entry(seen, n, &typed);
    else if (typed.word[0] && !file->message[0])
        snprintf(file->message, sizeof file->message,
                 "\"%s\" begins a line, but only `sheet` and a to %c do; put a # before what is a note",
                 typed.word, 'a' + file->entries - 1);
}

void prediction_file_read(PredictionFile *file, const char *text, int entries) {
    Seen seen = {.file = file};
    *file = (PredictionFile){.entries = entries};
    for (int n = 0; n < entries; n++)
        snprintf(file->entry[n].why, sizeof file->entry[n].why, "nothing is typed yet");
    while (*text) {
        const size_t length = strcspn(text, "\n");
        read_line(&seen, text, length);
        text += length + (text[length] == '\n');
    }
}
