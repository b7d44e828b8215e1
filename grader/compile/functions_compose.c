// Puts a file together from two versions: their text, with the chosen functions of ours in their places, and
// those that these call.
#include "compile/functions.h"

#include "compile/tokens.h"

#include <stdio.h>
#include <string.h>

typedef struct Composer {
    FILE *out;
    const Functions *theirs, *ours;
    const Choice *choice;
    bool written[FUNCTIONS_MAX]; // of the functions of the file whose order does not count
} Composer;

bool choice_has(const Choice *choice, const char *name) {
    for (int i = 0; i < choice->count; i++)
        if (strcmp(choice->names[i], name) == 0)
            return true;
    return false;
}

static void write_function(FILE *out, const Functions *functions, const Function *function) {
    fwrite(functions->text + function->begin, 1, function->end - function->begin, out);
}

// Our function under the name that theirs has for it.
static void write_renamed(FILE *out, const Functions *ours, const Function *function, const char *called) {
    const char *at = ours->text + function->begin, *end = ours->text + function->end;
    while (at < end) {
        const char *from = at;
        const Token token = tokens_next(&at);
        const bool named = token.kind == TOKEN_WORD && token_is(&token, function->name);
        fwrite(from, 1, (size_t)(token.text - from), out);
        if (named)
            fputs(called, out);
        else
            fwrite(token.text, 1, token.length, out);
    }
}

// All definitions of the name in ours.
static void write_ours(Composer *to, const char *name, const char *called) {
    for (int i = 0; i < to->ours->count; i++) {
        const Function *function = &to->ours->list[i];
        if (strcmp(function->name, name) != 0)
            continue;
        write_renamed(to->out, to->ours, function, called ? called : name);
        fputc('\n', to->out);
    }
}

// Our functions that the one of this name calls, and theirs lacks. Ours are written in the order of their
// use.
static void write_missing(Composer *to, const char *name) {
    const Function *caller = functions_find(to->ours, name);
    for (int i = 0; caller && i < to->ours->count; i++) {
        const Function *function = &to->ours->list[i];
        if (function == caller || to->written[i] || functions_find(to->theirs, function->name) ||
            choice_has(to->choice, function->name) ||
            !tokens_mention(to->ours->text + caller->begin, caller->end - caller->begin, function->name))
            continue;
        to->written[i] = true;
        write_missing(to, function->name);
        write_function(to->out, to->ours, function);
        fputc('\n', to->out);
    }
}

// Which chosen function stands at their function of this name; -1: none.
static int chosen(const Choice *choice, const char *name) {
    for (int i = 0; i < choice->count; i++)
        if (strcmp(choice->called[i] ? choice->called[i] : choice->names[i], name) == 0)
            return i;
    return -1;
}

// Has the branch of their function number k an earlier definition of its name?
static bool is_repeated(const Functions *theirs, int k) {
    for (int i = 0; i < k; i++)
        if (strcmp(theirs->list[i].name, theirs->list[k].name) == 0 &&
            theirs->list[i].branch == theirs->list[k].branch)
            return true;
    return false;
}

// Their file, with functions exchanged.
static void compose_in_theirs(Composer *to) {
    size_t from = 0;
    for (int k = 0; k < to->theirs->count; k++) {
        const Function *function = &to->theirs->list[k];
        const int i = chosen(to->choice, function->name);
        if (i < 0)
            continue;
        fwrite(to->theirs->text + from, 1, function->begin - from, to->out);
        from = function->end;
        if (is_repeated(to->theirs, k))
            continue;
        write_missing(to, to->choice->names[i]);
        write_ours(to, to->choice->names[i], to->choice->called[i]);
    }
    fputs(to->theirs->text + from, to->out);
}

// Their functions that ours does not have, up to number `end`.
static void write_own(Composer *to, int end) {
    for (int k = 0; k < end; k++) {
        const Function *function = &to->theirs->list[k];
        if (to->written[k] || functions_find(to->ours, function->name) ||
            chosen(to->choice, function->name) >= 0)
            continue;
        to->written[k] = true;
        write_function(to->out, to->theirs, function);
        fputs("\n\n", to->out);
    }
}

static void write_theirs(Composer *to, const char *name) {
    for (int k = 0; k < to->theirs->count; k++)
        if (strcmp(to->theirs->list[k].name, name) == 0 && !is_repeated(to->theirs, k)) {
            write_own(to, k);
            for (int j = k; j < to->theirs->count; j++)
                if (strcmp(to->theirs->list[j].name, name) == 0 &&
                    to->theirs->list[j].branch == to->theirs->list[k].branch)
                    write_function(to->out, to->theirs, &to->theirs->list[j]);
            return;
        }
}

// Our file, with their functions but for the chosen ones.
static void compose_in_ours(Composer *to) {
    size_t from = 0;
    for (int i = 0; i < to->ours->count; i++) {
        const Function *function = &to->ours->list[i];
        if (choice_has(to->choice, function->name) || !functions_find(to->theirs, function->name))
            continue;
        fwrite(to->ours->text + from, 1, function->begin - from, to->out);
        from = function->end;
        if (!is_repeated(to->ours, i))
            write_theirs(to, function->name);
    }
    fputs(to->ours->text + from, to->out);
}

char *functions_compose(const Functions *theirs, const Functions *ours, const Choice *choice) {
    char *text = NULL;
    size_t size;
    Composer to = {.out = open_memstream(&text, &size), .theirs = theirs, .ours = ours, .choice = choice};
    if (!to.out)
        return NULL;
    if (choice->outside)
        compose_in_ours(&to);
    else
        compose_in_theirs(&to);
    fclose(to.out);
    return text;
}
