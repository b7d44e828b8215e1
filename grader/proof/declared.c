#include "proof/declared.h"

#include <string.h>

static bool same_text(const Source *source, int a, int b) {
    const Piece *one = &source->pieces[a], *other = &source->pieces[b];
    return one->length == other->length && memcmp(one->text, other->text, one->length) == 0;
}

// The "{" around piece i; -1 outside of all.
static int enclosing(const Source *source, int i) {
    for (int k = i - 1; k >= 0; k--)
        if (source_is(source, k, "}") && source->pieces[k].partner >= 0)
            k = source->pieces[k].partner;
        else if (source_is(source, k, "{"))
            return k;
    return -1;
}

// The "{" of the function whose parameter piece i is; -1 when it is none.
static int body_of_parameter(const Source *source, int i) {
    int k = i;
    while (k >= 0 && !source_is_one_of(source, k, "( ; { }"))
        k--;
    if (k < 0 || !source_is(source, k, "(") || source->pieces[k].partner < 0)
        return -1;
    const int after = source->pieces[k].partner + 1;
    return source_is(source, after, "{") && !source_is_one_of(source, k - 1, "if for while switch") ? after
                                                                                                    : -1;
}

static Declared make(const Source *source, int type, int name, int stars) {
    const int body = body_of_parameter(source, name), around = body >= 0 ? body : enclosing(source, name);
    Declared declared = {.type = type, .name = name, .stars = stars, .begin = name, .end = source->count};
    declared.field = body < 0 && around > 0 &&
                     (source_is(source, around - 1, "struct") || source_is(source, around - 2, "struct"));
    if (around >= 0 && !declared.field)
        declared.end = source->pieces[around].partner;
    return declared;
}

// Takes the names that follow the type at piece i: "float a, *b = c;". Returns the piece behind the last one.
static int take_names(Declarations *declarations, const Source *source, int i) {
    const int type = i++;
    for (;;) {
        int stars = 0;
        for (; source_is(source, i, "*"); i++)
            stars++;
        if (i >= source->count || source->pieces[i].kind != PIECE_NAME || source_is_type(source, i) ||
            !source_is_one_of(source, i + 1, "= ; , ) [") || declarations->count == DECLARED_MAX)
            return i;
        declarations->list[declarations->count++] = make(source, type, i, stars);
        const int comma = source_find(source, i + 1, ","), end = source_find(source, i + 1, ";");
        if (comma < 0 || end < 0 || end < comma)
            return i;
        i = comma + 1;
    }
}

void declared_find(Declarations *declarations, const Source *source) {
    declarations->count = 0;
    for (int i = 0; i < source->count; i++)
        if (source_is_type(source, i))
            take_names(declarations, source, i);
}

const Declared *declared_at(const Declarations *declarations, const Source *source, int i) {
    const bool field = source_is_one_of(source, i - 1, ". ->");
    for (int k = declarations->count - 1; k >= 0; k--) {
        const Declared *declared = &declarations->list[k];
        if (declared->field == field && declared->begin < i && i < declared->end &&
            same_text(source, declared->name, i))
            return declared;
    }
    return NULL;
}

bool declared_may_stand(const Source *source, const Declared *other, const Declared *one, int i) {
    return other->field == one->field && other->begin < i && i < other->end && other->stars == one->stars &&
           same_text(source, other->type, one->type) && !same_text(source, other->name, one->name);
}
