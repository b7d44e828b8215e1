#include "proof/mutations.h"

#include "proof/declared.h"

enum { MAX_OTHERS = 3 };

static void exchange(Mutants *mutants, const Source *source, const Declarations *declarations,
                     const Declared *declared, int i) {
    int others = 0;
    for (int k = declarations->count - 1; k >= 0 && others < MAX_OTHERS; k--) {
        const Declared *other = &declarations->list[k];
        if (!declared_may_stand(source, other, declared, i))
            continue;
        const Piece *name = &source->pieces[other->name];
        mutants_add(mutants, source, i, i, "%.*s", (int)name->length, name->text);
        others++;
    }
}

static void turn_sign(Mutants *mutants, const Source *source, const Declared *declared, int i) {
    const Piece *piece = &source->pieces[i];
    if (source_is_one_of(source, declared->type, "int float vec2 vec3 vec4") && declared->stars == 0 &&
        source_is_one_of(source, i - 1, "( , = + * / < <= > >= return"))
        mutants_add(mutants, source, i, i, "-%.*s", (int)piece->length, piece->text);
}

// Is it being declared here, so that it only gets another name?
static bool is_declared_here(const Source *source, int i) {
    while (source_is(source, i - 1, "*"))
        i--;
    return source_is_type(source, i - 1);
}

void mutations_of_variables(Mutants *mutants, const Source *source) {
    static Declarations declarations;
    declared_find(&declarations, source);
    for (int i = 0; i < source->count; i++) {
        const Declared *declared =
            source->pieces[i].kind == PIECE_NAME && source->pieces[i].task[0] && !is_declared_here(source, i)
                ? declared_at(&declarations, source, i)
                : NULL;
        if (!declared)
            continue;
        exchange(mutants, source, &declarations, declared, i);
        turn_sign(mutants, source, declared, i);
    }
}
