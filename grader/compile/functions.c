// Walks over a file's tokens with a count of braces and notes where each definition at the top begins and
// ends; compares definitions by their tokens.
#include "compile/functions.h"
#include "scene/count.h"

#include "compile/tokens.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_NESTED = 32 };

// Where an #if began: what the text after its #else begins with, too.
typedef struct Fork {
    int depth, branch;
    int end_depth; // of its first branch; -1: not known yet
    bool inside;   // a function
    bool skipped;  // "#if 0": anything may stand there
} Fork;

typedef struct Splitter {
    Functions *functions;
    const char *text;
    int depth, parentheses; // of braces, of parentheses outside of braces
    const char *begin;      // of the declaration; NULL: between two
    Token name, last;       // the word before the last parenthesis of a declaration, and the last token
    bool is_value;          // an = was seen: the brace begins an initializer
    bool inside;            // a function
    Function open;          // that one
    int open_forks;
    Fork forks[MAX_NESTED];
    int fork_count, branch, branches;
} Splitter;

// Words before a parenthesis that name no function.
static bool is_no_name(const Token *word) {
    static const char *const words[] = {
        "__attribute__", "__declspec", "layout", "subroutine", "_Alignas", "alignas", "__asm__",    "asm",
        "void",          "int",        "float",  "char",       "unsigned", "const",   "__typeof__", "typeof"};
    for (size_t i = 0; i < COUNT(words); i++)
        if (token_is(word, words[i]))
            return true;
    return word->kind != TOKEN_WORD;
}

static void end_declaration(Splitter *at) {
    at->begin = NULL;
    at->name = (Token){0};
    at->is_value = false;
    at->parentheses = 0;
}

static void open_function(Splitter *at) {
    const size_t length = at->name.length < FUNCTIONS_NAME ? at->name.length : FUNCTIONS_NAME - 1;
    at->inside = true;
    at->open_forks = at->fork_count;
    at->open = (Function){.begin = (size_t)(at->begin - at->text), .branch = at->branch};
    memcpy(at->open.name, at->name.text, length);
}

static void close_function(Splitter *at, const char *end) {
    Functions *functions = at->functions;
    at->inside = false;
    at->open.end = (size_t)(end - at->text);
    if (functions->count == FUNCTIONS_MAX || at->fork_count != at->open_forks)
        functions->whole = true;
    else
        functions->list[functions->count++] = at->open;
}

static void begin_fork(Splitter *at, const Token *token) {
    const char *rest = strstr(token->text, "if") + 2;
    if (at->fork_count == MAX_NESTED) {
        at->functions->whole = true;
        return;
    }
    at->forks[at->fork_count++] = (Fork){.depth = at->depth,
                                         .end_depth = -1,
                                         .branch = at->branch,
                                         .inside = at->inside,
                                         .skipped = rest[0] == ' ' && rest[1] == '0'};
    at->branch = ++at->branches;
}

// Each branch may open the same braces, but not the first or last of a function.
static void end_branch(Splitter *at, bool last) {
    Fork *fork = &at->forks[at->fork_count - 1];
    const bool first = fork->end_depth < 0;
    if (!fork->skipped && (at->inside != fork->inside ||
                           (at->depth != (first ? fork->depth : fork->end_depth) && (last || !first))))
        at->functions->whole = true;
    if (first)
        fork->end_depth = fork->skipped ? fork->depth : at->depth;
    at->inside = fork->inside;
    at->depth = last ? fork->end_depth : fork->depth;
    at->branch = last ? fork->branch : ++at->branches;
    fork->skipped = false;
    at->fork_count -= last;
}

static void take_fork(Splitter *at, const Token *token) {
    if (token_is_directive(token, "if"))
        begin_fork(at, token);
    else if (at->fork_count > 0 && (token_is_directive(token, "else") || token_is_directive(token, "elif")))
        end_branch(at, false);
    else if (at->fork_count > 0 && token_is_directive(token, "endif"))
        end_branch(at, true);
}

static void take_directive(Splitter *at, const Token *token) {
    take_fork(at, token);
    if (at->depth == 0)
        end_declaration(at);
}

static void take_open_brace(Splitter *at) {
    const bool is_body = at->depth == 0 && at->parentheses == 0 && !at->is_value && at->name.length > 0 &&
                         token_is(&at->last, ")");
    if (is_body && !at->inside)
        open_function(at);
    at->depth++;
}

static void take_close_brace(Splitter *at, const char *end) {
    if (--at->depth < 0)
        at->functions->whole = true;
    if (at->depth > 0 || !at->inside)
        return;
    close_function(at, end);
    end_declaration(at);
}

static void take_outside(Splitter *at, const Token *token) {
    if (token_is(token, ";") && at->parentheses == 0) {
        end_declaration(at);
        return;
    }
    if (!at->begin)
        at->begin = token->text;
    if (token_is(token, "=") && at->parentheses == 0)
        at->is_value = true;
    if (token_is(token, "(") && at->parentheses++ == 0 && at->last.kind == TOKEN_WORD &&
        !is_no_name(&at->last))
        at->name = at->last;
    if (token_is(token, ")"))
        at->parentheses--;
}

static void take(Splitter *at, const Token *token) {
    if (token->kind == TOKEN_DIRECTIVE)
        take_directive(at, token);
    else if (token_is(token, "{") && token->kind == TOKEN_MARK)
        take_open_brace(at);
    else if (token_is(token, "}") && token->kind == TOKEN_MARK)
        take_close_brace(at, token->text + 1);
    else if (at->depth == 0)
        take_outside(at, token);
    at->last = *token;
}

void functions_split(Functions *functions, const char *text) {
    static _Thread_local Splitter at;
    *functions = (Functions){.text = text};
    at = (Splitter){.functions = functions, .text = text};
    for (const char *next = text;;) {
        const Token token = tokens_next(&next);
        if (token.kind == TOKEN_END)
            break;
        take(&at, &token);
    }
    if (at.depth != 0 || at.fork_count != 0)
        functions->whole = true;
    if (functions->whole)
        functions->count = 0;
}

const Function *functions_find(const Functions *functions, const char *name) {
    for (int i = 0; i < functions->count; i++)
        if (strcmp(functions->list[i].name, name) == 0)
            return &functions->list[i];
    return NULL;
}

// The first definition of the name from number *i on; *i moves behind it.
static const Function *next_named(const Functions *functions, const char *name, int *i) {
    while (*i < functions->count) {
        const Function *function = &functions->list[(*i)++];
        if (strcmp(function->name, name) == 0)
            return function;
    }
    return NULL;
}

bool functions_same(const Functions *a, const Functions *b, const char *name) {
    int i = 0, j = 0;
    for (;;) {
        const Function *left = next_named(a, name, &i), *right = next_named(b, name, &j);
        if (!left || !right)
            return left == right;
        if (!tokens_equal(a->text + left->begin, left->end - left->begin, b->text + right->begin,
                          right->end - right->begin))
            return false;
    }
}

// The text outside of functions; freed by the caller.
static char *outside(const Functions *functions) {
    char *text = NULL;
    size_t size, from = 0;
    FILE *out = open_memstream(&text, &size);
    for (int i = 0; i < functions->count; i++) {
        fwrite(functions->text + from, 1, functions->list[i].begin - from, out);
        fputc(' ', out);
        from = functions->list[i].end;
    }
    fputs(functions->text + from, out);
    fclose(out);
    return text;
}

bool functions_same_outside(const Functions *a, const Functions *b) {
    char *left = outside(a), *right = outside(b);
    const bool same = tokens_equal(left, strlen(left), right, strlen(right));
    free(left);
    free(right);
    return same;
}

// Length of the text before the function's body.
static size_t head_length(const char *text, const Function *function) {
    const char *at = text + function->begin;
    for (;;) {
        const Token token = tokens_next(&at);
        if (token.kind == TOKEN_END || (token.kind == TOKEN_MARK && token_is(&token, "{")))
            return (size_t)(token.text - text) - function->begin;
    }
}

// Parameters may have other names, too: only what stands before a name counts.
bool functions_same_signature(const Functions *a, const char *other, const Functions *b, const char *name) {
    const Function *left = functions_find(a, other), *right = functions_find(b, name);
    if (!left || !right)
        return false;
    const char *i = a->text + left->begin, *j = b->text + right->begin;
    const char *i_end = i + head_length(a->text, left), *j_end = j + head_length(b->text, right);
    for (;;) {
        const Token x = tokens_next(&i), y = tokens_next(&j);
        if (x.text >= i_end || y.text >= j_end)
            return x.text >= i_end && y.text >= j_end;
        const bool named = token_is(&x, other) && token_is(&y, name);
        const char *after = i, *after_other = j;
        const Token next = tokens_next(&after), next_other = tokens_next(&after_other);
        const bool parameter = (token_is(&next, ",") || token_is(&next, ")")) &&
                               (token_is(&next_other, ",") || token_is(&next_other, ")"));
        if (!named && !parameter && !tokens_same(&x, &y))
            return false;
    }
}
