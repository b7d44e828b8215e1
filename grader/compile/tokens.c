// Cuts a source into words, past comments, strings and directives, and compares words.
#include "compile/tokens.h"

#include <ctype.h>
#include <string.h>

static bool is_word(char c) {
    return isalnum((unsigned char)c) || c == '_';
}

static const char *skip_comment(const char *at) {
    if (at[1] == '/')
        return at + strcspn(at, "\n");
    const char *end = strstr(at + 2, "*/");
    return end ? end + 2 : at + strlen(at);
}

static bool begins_comment(const char *at) {
    return at[0] == '/' && (at[1] == '/' || at[1] == '*');
}

static const char *skip_blanks(const char *at) {
    for (;;) {
        if (isspace((unsigned char)*at) || (at[0] == '\\' && (at[1] == '\n' || at[1] == '\r')))
            at++;
        else if (begins_comment(at))
            at = skip_comment(at);
        else
            return at;
    }
}

// Behind a string or character.
static const char *skip_quoted(const char *at) {
    const char quote = *at++;
    while (*at && *at != quote && *at != '\n')
        at += at[0] == '\\' && at[1] ? 2 : 1;
    return at + (*at == quote);
}

// A line that ends in a backslash goes on; so does a comment that began on it.
static const char *skip_directive(const char *at) {
    while (*at && *at != '\n') {
        if (at[0] == '/' && at[1] == '*')
            at = skip_comment(at);
        else if (at[0] == '\\' && at[1] == '\r' && at[2] == '\n')
            at += 3;
        else
            at += at[0] == '\\' && at[1] ? 2 : 1;
    }
    return at;
}

Token tokens_next(const char **at) {
    const char *begin = skip_blanks(*at), *end = begin;
    Token token = {.kind = TOKEN_END, .text = begin};
    if (is_word(*begin)) {
        token.kind = TOKEN_WORD;
        while (is_word(*end))
            end++;
    } else if (*begin == '"' || *begin == '\'') {
        token.kind = TOKEN_TEXT;
        end = skip_quoted(begin);
    } else if (*begin == '#') {
        token.kind = TOKEN_DIRECTIVE;
        end = skip_directive(begin);
    } else if (*begin) {
        token.kind = TOKEN_MARK;
        end++;
    }
    token.length = (size_t)(end - begin);
    *at = end;
    return token;
}

bool token_is(const Token *token, const char *word) {
    return token->length == strlen(word) && strncmp(token->text, word, token->length) == 0;
}

bool token_is_directive(const Token *token, const char *name) {
    if (token->kind != TOKEN_DIRECTIVE)
        return false;
    const char *at = token->text + 1;
    at += strspn(at, " \t");
    const size_t length = strlen(name);
    return strncmp(at, name, length) == 0 && (strcmp(name, "if") == 0 || !is_word(at[length]));
}

// Directives hold blanks and comments of their own.
static bool same_directive(const Token *a, const Token *b) {
    return tokens_equal(a->text + 1, a->length - 1, b->text + 1, b->length - 1);
}

bool tokens_same(const Token *a, const Token *b) {
    return a->length == b->length && memcmp(a->text, b->text, a->length) == 0;
}

static bool same_token(const Token *a, const Token *b) {
    if (a->kind != b->kind)
        return false;
    if (a->kind == TOKEN_DIRECTIVE)
        return same_directive(a, b);
    return tokens_same(a, b);
}

bool tokens_equal(const char *a, size_t a_length, const char *b, size_t b_length) {
    const char *a_end = a + a_length, *b_end = b + b_length;
    for (;;) {
        const Token left = tokens_next(&a), right = tokens_next(&b);
        const bool left_ends = left.kind == TOKEN_END || left.text >= a_end;
        const bool right_ends = right.kind == TOKEN_END || right.text >= b_end;
        if (left_ends || right_ends)
            return left_ends && right_ends;
        if (!same_token(&left, &right))
            return false;
    }
}

bool tokens_mention(const char *text, size_t length, const char *name) {
    for (const char *at = text;;) {
        const Token token = tokens_next(&at);
        if (token.kind == TOKEN_END || token.text >= text + length)
            return false;
        if (token.kind == TOKEN_WORD && token_is(&token, name))
            return true;
    }
}
