// Cuts a function at its TODOs and compares the pieces word by word.
#include "diagnose/task_text.h"

#include "compile/functions.h"
#include "compile/tokens.h"

#include <stdbool.h>
#include <string.h>

enum { BEGIN_WORDS = 3 };

typedef struct Span {
    const char *begin, *end;
} Span;

// A function, or the text between two.
typedef struct TodoPlace {
    const char *function; // its name; "": none
    Span span;
} TodoPlace;

// Functions that are not in `handed_out` are what was written between two: whole functions are the answer of
// some tasks.
static TodoPlace place_of(const Functions *functions, const char *at, const Functions *handed_out) {
    TodoPlace place = {"", {functions->text, functions->text + strlen(functions->text)}};
    for (int i = 0; i < functions->count; i++) {
        const Function *function = &functions->list[i];
        const char *begin = functions->text + function->begin, *end = functions->text + function->end;
        if (at >= begin && at < end)
            return (TodoPlace){function->name, {begin, end}};
        if (!functions_find(handed_out, function->name))
            continue;
        if (end <= at)
            place.span.begin = end;
        else if (begin < place.span.end)
            place.span.end = begin;
    }
    return place;
}

// Where the comment begins that the mark stands in.
static const char *comment_begin(const char *at, const char *least) {
    while (at > least && at[-1] != '\n' && !(at[0] == '/' && (at[1] == '/' || at[1] == '*')))
        at--;
    return at;
}

static const char *find_todo(const char *at, const char *end) {
    const char *found = strstr(at, "TODO(");
    return found && found < end ? found : NULL;
}

static const char *next_todo(const char *at, Span span) {
    return find_todo(at + 1, span.end);
}

static const char *todo_before(const char *at, Span span) {
    const char *last = NULL;
    for (const char *todo = find_todo(span.begin, at); todo; todo = find_todo(todo + 1, at))
        last = todo;
    return last;
}

static const char *last_todo(Span span) {
    return todo_before(span.end, span);
}

// From the mark's comment to the next.
static Span after(const char *at, Span span) {
    const char *next = next_todo(at, span);
    return (Span){comment_begin(at, span.begin), next ? comment_begin(next, span.begin) : span.end};
}

// From the TODO before it.
static Span before(const char *at, Span span) {
    const char *todo = todo_before(at, span);
    return (Span){todo ? comment_begin(todo, span.begin) : span.begin, comment_begin(at, span.begin)};
}

static bool same(Span a, Span b) {
    return tokens_equal(a.begin, (size_t)(a.end - a.begin), b.begin, (size_t)(b.end - b.begin));
}

// "TODO(3.5)" and "TODO(3.5)", or none and none.
static bool same_mark(const char *a, const char *b) {
    if (!a || !b)
        return a == b;
    const size_t length = strcspn(a, ")");
    return strncmp(a, b, length + 1) == 0;
}

// Was code put in above the function's first TODO, and none below its last?
static bool written_above(Span theirs, Span ours) {
    const char *first = find_todo(theirs.begin, theirs.end), *our_first = find_todo(ours.begin, ours.end);
    const char *last = last_todo(theirs), *our_last = last_todo(ours);
    return first && our_first && same_mark(first, our_first) && same_mark(last, our_last) &&
           !same(before(first, theirs), before(our_first, ours)) &&
           same(after(last, theirs), after(our_last, ours));
}

// How many words does the piece have, as far as `most`?
static int count_words(Span piece, int most) {
    int count = 0;
    for (const char *at = piece.begin; count < most; count++) {
        const Token token = tokens_next(&at);
        if (token.kind == TOKEN_END || token.text >= piece.end)
            return count;
    }
    return count;
}

// Do both begin with the same few words?
static bool same_begin(const char *a, const char *b) {
    for (int i = 0; i < BEGIN_WORDS; i++) {
        const Token x = tokens_next(&a), y = tokens_next(&b);
        if (x.kind != y.kind || !tokens_same(&x, &y))
            return false;
    }
    return true;
}

static bool is_empty(Span piece) {
    return count_words(piece, 1) == 0;
}

// Does a TODO right below this one have something written below it? The answers of both may stand there.
static bool shares_below(const char *at, Span theirs, const char *our_at, Span ours) {
    while (is_empty(after(at, theirs)) && is_empty(after(our_at, ours))) {
        at = next_todo(at, theirs);
        our_at = next_todo(our_at, ours);
        if (!at || !our_at || !same_mark(at, our_at))
            return false;
        if (!same(after(at, theirs), after(our_at, ours)))
            return true;
    }
    return false;
}

// Stands this TODO right below another one, so that what is written here may be the answer of that?
static bool shares_above(const char *at, Span theirs, const char *our_at, Span ours) {
    const char *other = todo_before(at, theirs), *our_other = todo_before(our_at, ours);
    return other && our_other && same_mark(other, our_other) && is_empty(after(other, theirs)) &&
           is_empty(after(our_other, ours));
}

// The last words of the piece, of which there may be fewer.
static Span end_of(Span piece) {
    const char *begins[BEGIN_WORDS] = {piece.begin, piece.begin, piece.begin};
    for (const char *at = piece.begin;;) {
        const Token token = tokens_next(&at);
        if (token.kind == TOKEN_END || token.text >= piece.end)
            return (Span){begins[0], piece.end};
        memmove(begins, begins + 1, (BEGIN_WORDS - 1) * sizeof *begins);
        begins[BEGIN_WORDS - 1] = token.text;
    }
}

// Does the piece hold these words, too, above its end?
static bool holds_above_end(Span piece, Span words) {
    const int count = count_words(words, BEGIN_WORDS);
    for (const char *at = piece.begin; at < piece.end;) {
        const char *end = at;
        for (int i = 0; i < count; i++)
            tokens_next(&end);
        if (end < piece.end && same((Span){at, end}, words))
            return true;
        if (tokens_next(&at).kind == TOKEN_END)
            return false;
    }
    return false;
}

// Stand the words right above the mark that were handed out there?
static bool same_right_above(const char *at, Span theirs, const char *our_at, Span ours) {
    const Span words = end_of(before(our_at, ours));
    return !is_empty(words) && same(end_of(before(at, theirs)), words);
}

// Was code put in between the mark and those words?
static bool written_right_above(const char *at, Span theirs, const char *our_at, Span ours) {
    const Span words = end_of(before(our_at, ours));
    return !is_empty(words) && !same_right_above(at, theirs, our_at, ours) &&
           holds_above_end(before(at, theirs), words);
}

// Where answers stand above their TODOs: what stands above those words belongs to the TODO before.
static bool untouched_above(const char *at, Span theirs, const char *our_at, Span ours) {
    return same(before(at, theirs), before(our_at, ours)) ||
           (todo_before(at, theirs) && same_right_above(at, theirs, our_at, ours));
}

static TaskText compare_at(const char *at, Span theirs, const char *our_at, Span ours) {
    const bool right_above = written_right_above(at, theirs, our_at, ours);
    if (written_above(theirs, ours))
        return untouched_above(at, theirs, our_at, ours) ? TASK_TEXT_HANDED_OUT : TASK_TEXT_WRITTEN;
    if (same(after(at, theirs), after(our_at, ours)))
        return right_above || shares_below(at, theirs, our_at, ours) ? TASK_TEXT_EITHER
                                                                     : TASK_TEXT_HANDED_OUT;
    if (same_mark(next_todo(at, theirs), next_todo(our_at, ours)))
        return shares_above(at, theirs, our_at, ours) ? TASK_TEXT_EITHER : TASK_TEXT_WRITTEN;
    const Span piece = after(our_at, ours); // and code of tasks whose TODOs are gone
    if (count_words(piece, BEGIN_WORDS) == BEGIN_WORDS && !same_begin(after(at, theirs).begin, piece.begin))
        return TASK_TEXT_WRITTEN;
    return right_above ? TASK_TEXT_EITHER : TASK_TEXT_UNKNOWN;
}

bool task_text_put_before(const char *text, const char *at, const char *mark, const char *without) {
    static Functions functions, our_functions;
    functions_split(&functions, text);
    functions_split(&our_functions, without);
    const Span theirs = after(at, place_of(&functions, at, &our_functions).span);
    for (const char *our_at = strstr(without, mark); our_at; our_at = strstr(our_at + 1, mark)) {
        const Span ours = after(our_at, place_of(&our_functions, our_at, &our_functions).span);
        for (Span rest = theirs; rest.begin < theirs.end;) {
            const Token token = tokens_next(&rest.begin);
            if (token.kind == TOKEN_END || token.text >= theirs.end)
                break;
            if (same(rest, ours))
                return true;
        }
    }
    return false;
}

TaskText task_text_compare(const char *text, const char *at, const char *mark, const char *skeleton) {
    static Functions functions, our_functions;
    TaskText found = TASK_TEXT_UNKNOWN;
    functions_split(&functions, text);
    functions_split(&our_functions, skeleton);
    const TodoPlace theirs = place_of(&functions, at, &our_functions);
    for (const char *our_at = strstr(skeleton, mark); our_at; our_at = strstr(our_at + 1, mark)) {
        const TodoPlace ours = place_of(&our_functions, our_at, &our_functions);
        if (strcmp(theirs.function, ours.function) != 0)
            continue;
        const TaskText one = compare_at(at, theirs.span, our_at, ours.span);
        if (one == TASK_TEXT_HANDED_OUT)
            return one;
        if (one != TASK_TEXT_UNKNOWN)
            found = one;
    }
    return found;
}
