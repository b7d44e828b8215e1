// Keeps changes once each and only inside of answers, writes one for people, and applies it to a text.
#include "proof/mutant.h"

#include "scene/check.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// On one line, with single blanks.
static char *tidy(const char *text, size_t length) {
    char *result = calloc(length + 1, 1), *end = result;
    INVARIANT(result);
    for (size_t i = 0; i < length; i++)
        if (!isspace((unsigned char)text[i]))
            *end++ = text[i];
        else if (end > result && end[-1] != ' ')
            *end++ = ' ';
    return result;
}

char *mutant_quote(const Source *source, int first, int last) {
    const Piece *a = &source->pieces[first], *b = &source->pieces[last];
    return tidy(a->text, (size_t)(b->text + b->length - a->text));
}

static bool is_in_answers(const Source *source, int first, int last) {
    for (int i = first; i <= last; i++)
        if (!source->pieces[i].task[0] || strcmp(source->pieces[i].task, source->pieces[first].task) != 0)
            return false;
    return true;
}

// One more than the places before it in its line where the same text changes.
static int count_places(const Mutants *mutants, const Mutant *mutant) {
    for (int i = mutants->count - 1; i >= 0; i--) {
        const Mutant *other = &mutants->list[i];
        if (other->file != mutant->file || other->line != mutant->line ||
            strcmp(other->before, mutant->before) != 0)
            continue;
        return other->begin == mutant->begin ? other->nth : other->nth + 1;
    }
    return 1;
}

static bool is_known(const Mutants *mutants, const Mutant *mutant) {
    for (int i = 0; i < mutants->count; i++) {
        const Mutant *other = &mutants->list[i];
        if (other->file == mutant->file && other->begin == mutant->begin && other->end == mutant->end &&
            strcmp(other->replacement, mutant->replacement) == 0)
            return true;
    }
    return strcmp(mutant->before, mutant->replacement) == 0;
}

static void take(Mutants *mutants, Mutant mutant) {
    if (is_known(mutants, &mutant)) {
        free(mutant.before);
        free(mutant.replacement);
        return;
    }
    if (mutants->count == mutants->room) {
        mutants->room = 2 * mutants->room + 256;
        mutants->list = realloc(mutants->list, (size_t)mutants->room * sizeof *mutants->list);
        INVARIANT(mutants->list);
    }
    mutants->list[mutants->count++] = mutant;
}

void mutants_add(Mutants *mutants, const Source *source, int first, int last, const char *format, ...) {
    char text[2000];
    if (!is_in_answers(source, first, last))
        return;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    const Piece *a = &source->pieces[first], *b = &source->pieces[last];
    Mutant mutant = {.file = mutants->file,
                     .begin = (size_t)(a->text - source->text),
                     .end = (size_t)(b->text + b->length - source->text),
                     .line = a->line,
                     .before = mutant_quote(source, first, last),
                     .replacement = tidy(text, strlen(text))};
    memcpy(mutant.task, a->task, sizeof mutant.task);
    mutant.nth = count_places(mutants, &mutant);
    take(mutants, mutant);
}

void mutants_add_each(Mutants *mutants, const Source *source, int i, const char *texts) {
    for (size_t length; *texts; texts += length + (texts[length] == ' ')) {
        length = strcspn(texts, " ");
        mutants_add(mutants, source, i, i, "%.*s", (int)length, texts);
    }
}

void mutants_destroy(Mutants *mutants) {
    for (int i = 0; i < mutants->count; i++) {
        free(mutants->list[i].before);
        free(mutants->list[i].replacement);
    }
    free(mutants->list);
    *mutants = (Mutants){0};
}

char *mutant_apply(const Mutant *mutant, const char *text) {
    const size_t size = strlen(text) + strlen(mutant->replacement) + 1;
    char *result = malloc(size);
    INVARIANT(result);
    snprintf(result, size, "%.*s%s%s", (int)mutant->begin, text, mutant->replacement, text + mutant->end);
    return result;
}
