// Cuts an annotated source into words, marks those of the answers, and pairs brackets.
#include "proof/source.h"

#include "compile/tokens.h"
#include "scene/check.h"
#include "scene/count.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Where we are among the marks of the tasks.
typedef struct MarkPosition {
    char task[PIECE_TASK];
    bool inside, skipped; // of a marked block; in its second half, which only the skeleton has
    int nested;           // other #ifs inside of it
} MarkPosition;

static void pass_directive(MarkPosition *place, const Token *token) {
    const bool conditional = token_is_directive(token, "if");
    if (!place->inside && strncmp(token->text, "#ifdef SOLUTION", 15) == 0) {
        *place = (MarkPosition){.inside = true};
        sscanf(token->text + 15, " // %7[0-9.]", place->task);
    } else if (place->inside && conditional) {
        place->nested++;
    } else if (place->inside && place->nested == 0 && token_is_directive(token, "else")) {
        place->skipped = true;
    } else if (place->inside && token_is_directive(token, "endif") && place->nested-- == 0) {
        *place = (MarkPosition){0};
    }
}

static bool touches(const Piece *piece, const Token *token) {
    return piece->text + piece->length == token->text;
}

// "1", "." and "5f" are one number, "<" and "=" one operator.
static bool belongs_to(const Piece *piece, const Token *token) {
    static const char *const pairs[] = {"<=", ">=", "==", "!=", "&&", "||", "++", "--", "+=",
                                        "-=", "*=", "/=", "%=", "->", "<<", ">>", "|=", "&="};
    if (!touches(piece, token))
        return false;
    if (piece->kind == PIECE_NUMBER)
        return token->text[0] == '.' || (piece->text[piece->length - 1] == '.' && token->kind == TOKEN_WORD);
    for (size_t i = 0; i < COUNT(pairs); i++)
        if (piece->kind == PIECE_MARK && piece->length == 1 && token->kind == TOKEN_MARK &&
            piece->text[0] == pairs[i][0] && token->text[0] == pairs[i][1])
            return true;
    return false;
}

static PieceKind kind_of(const Token *token) {
    if (token->kind == TOKEN_WORD)
        return isdigit((unsigned char)token->text[0]) ? PIECE_NUMBER : PIECE_NAME;
    return token->kind == TOKEN_MARK ? PIECE_MARK : PIECE_TEXT;
}

static void add(Source *source, const Token *token, const MarkPosition *place, int line) {
    if (source->count > 0 && belongs_to(&source->pieces[source->count - 1], token)) {
        source->pieces[source->count - 1].length += token->length;
        return;
    }
    Piece *piece = &source->pieces[source->count++];
    *piece = (Piece){kind_of(token), token->text, token->length, line, "", -1};
    memcpy(piece->task, place->task, sizeof piece->task);
}

static void pair_brackets(Source *source) {
    int *open = calloc((size_t)source->count + 1, sizeof *open), depth = 0;
    INVARIANT(open);
    for (int i = 0; i < source->count; i++)
        if (source_is_one_of(source, i, "( [ {")) {
            open[depth++] = i;
        } else if (source_is_one_of(source, i, ") ] }") && depth > 0) {
            source->pieces[i].partner = open[--depth];
            source->pieces[open[depth]].partner = i;
        }
    free(open);
}

void source_read(Source *source, const char *name, const char *text) {
    const char *dot = strrchr(name, '.');
    *source = (Source){.name = name, .text = text};
    source->c = dot && (strcmp(dot, ".c") == 0 || strcmp(dot, ".h") == 0);
    source->pieces = calloc(strlen(text) + 1, sizeof *source->pieces);
    INVARIANT(source->pieces);
    MarkPosition place = {0};
    int line = 1;
    const char *counted = text, *at = text;
    for (Token token = tokens_next(&at); token.kind != TOKEN_END; token = tokens_next(&at)) {
        for (; counted < token.text; counted++)
            line += *counted == '\n';
        if (token.kind == TOKEN_DIRECTIVE)
            pass_directive(&place, &token);
        else if (!place.skipped)
            add(source, &token, &place, line);
    }
    pair_brackets(source);
}

void source_destroy(Source *source) {
    free(source->pieces);
    *source = (Source){0};
}

bool source_is(const Source *source, int i, const char *text) {
    return i >= 0 && i < source->count && source->pieces[i].length == strlen(text) &&
           memcmp(source->pieces[i].text, text, source->pieces[i].length) == 0;
}

bool source_is_one_of(const Source *source, int i, const char *texts) {
    if (i < 0 || i >= source->count)
        return false;
    const Piece *piece = &source->pieces[i];
    for (size_t length; *texts; texts += length + (texts[length] == ' ')) {
        length = strcspn(texts, " ");
        if (length == piece->length && memcmp(texts, piece->text, length) == 0)
            return true;
    }
    return false;
}

// In C our types and those of GL have a capital and a small letter; constants have no small one.
static bool looks_like_a_type(const Piece *piece) {
    bool small = false;
    for (size_t i = 0; i < piece->length; i++)
        small = small || islower((unsigned char)piece->text[i]);
    return small && isupper((unsigned char)piece->text[0]);
}

bool source_is_type(const Source *source, int i) {
    if (i < 0 || i >= source->count || source->pieces[i].kind != PIECE_NAME)
        return false;
    return source_is_one_of(source, i,
                            "void bool int float double char unsigned size_t uint64_t uint vec2 vec3 vec4 "
                            "ivec2 ivec3 ivec4 bvec2 bvec3 mat2 mat3 mat4 vec2s vec3s vec4s mat3s mat4s "
                            "sampler2D sampler3D sampler2DShadow") ||
           (source->c && looks_like_a_type(&source->pieces[i]));
}

bool source_ends_operand(const Source *source, int i) {
    if (i < 0 || source_is_one_of(source, i, "return case else") || source_is_type(source, i))
        return false;
    return source->pieces[i].kind != PIECE_MARK || source_is_one_of(source, i, ") ]");
}

int source_find(const Source *source, int i, const char *mark) {
    for (; i < source->count; i++) {
        if (source_is(source, i, mark))
            return i;
        if (source_is_one_of(source, i, "( [ {"))
            i = source->pieces[i].partner < 0 ? source->count : source->pieces[i].partner;
        else if (source_is_one_of(source, i, ") ] }"))
            return -1;
    }
    return -1;
}
