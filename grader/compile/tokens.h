// C and GLSL, word by word: just enough to see where functions begin and end. No files.
#pragma once

#include <stdbool.h>
#include <stddef.h>

typedef enum TokenKind { TOKEN_END, TOKEN_WORD, TOKEN_TEXT, TOKEN_MARK, TOKEN_DIRECTIVE } TokenKind;

// A name or number, a string or character, one mark such as '{', or a whole line of the preprocessor with the
// lines that continue it.
typedef struct Token {
    TokenKind kind;
    const char *text; // not owned, of `length` bytes
    size_t length;
} Token;

// The token at or after *at, without the blanks and comments before it; *at moves behind it. A string that is
// not closed ends with its line, a comment that is not closed with the text.
Token tokens_next(const char **at);

// Is it just this text?
bool token_is(const Token *token, const char *word);

// Is it a directive of this name: "if" is also #ifdef and #ifndef.
bool token_is_directive(const Token *token, const char *name);

// Are they the same words, whatever their kind?
bool tokens_same(const Token *a, const Token *b);

// Do two texts say the same but for blanks and comments?
bool tokens_equal(const char *a, size_t a_length, const char *b, size_t b_length);

// Does the name stand in the text, outside of strings, comments and directives?
bool tokens_mention(const char *text, size_t length, const char *name);
