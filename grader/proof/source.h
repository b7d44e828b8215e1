// The solution's half of an annotated source, word by word, for those who change it somewhere.
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum { PIECE_TASK = 8 };

typedef enum PieceKind { PIECE_NAME, PIECE_NUMBER, PIECE_MARK, PIECE_TEXT } PieceKind;

// A name, a number with its point and suffix, a string, or an operator of one or two characters.
typedef struct Piece {
    PieceKind kind;
    const char *text; // in the source's text, `length` bytes
    size_t length;
    int line;              // from 1
    char task[PIECE_TASK]; // the answer that it belongs to, "7.10"; "" outside of answers
    int partner;           // of a bracket: the other one; else -1
} Piece;

typedef struct Source {
    const char *name, *text; // not owned
    bool c;                  // C; else GLSL
    Piece *pieces;           // without what the skeleton alone has
    int count;
} Source;

// Takes the annotated text of the file `name` apart. Both must outlive the source.
void source_read(Source *source, const char *name, const char *text);
void source_destroy(Source *source); // accepts a zeroed source

// Is piece i there and just this text?
bool source_is(const Source *source, int i, const char *text);

// Is piece i there and one of these texts, which are separated by blanks?
bool source_is_one_of(const Source *source, int i, const char *texts);

// Is piece i the name of a type, by the looks of it?
bool source_is_type(const Source *source, int i);

// Does an operand end with piece i, so that an operator behind it has two of them?
bool source_ends_operand(const Source *source, int i);

// The next piece from i on that is this mark outside of all brackets that begin there; -1 when there is none.
int source_find(const Source *source, int i, const char *mark);
