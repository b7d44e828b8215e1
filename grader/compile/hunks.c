// The longest common row of words by dynamic programming; what is not in it has changed.
#include "compile/hunks.h"

#include "compile/tokens.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct Words {
    Token list[HUNKS_MOST_WORDS];
    int lines[HUNKS_MOST_WORDS]; // of each in its text
    int count;
    bool too_many;
} Words;

static void read_words(Words *words, TextPart part) {
    const char *at = part.text + part.begin, *counted = part.text;
    int line = 1;
    while (!words->too_many) {
        const Token token = tokens_next(&at);
        if (token.kind == TOKEN_END || token.text >= part.text + part.end)
            return;
        for (; counted < token.text; counted++)
            line += *counted == '\n';
        words->too_many = words->count == HUNKS_MOST_WORDS;
        if (words->too_many)
            return;
        words->list[words->count] = token;
        words->lines[words->count++] = line;
    }
}

// common[i * (theirs + 1) + j]: length of the longest common row of ours from i on and theirs from j on.
static void measure(uint16_t *common, const Words *ours, const Words *theirs) {
    const int wide = theirs->count + 1;
    for (int i = ours->count - 1; i >= 0; i--)
        for (int j = theirs->count - 1; j >= 0; j--) {
            const uint16_t down = common[(i + 1) * wide + j], right = common[i * wide + j + 1];
            const uint16_t both = (uint16_t)(common[(i + 1) * wide + j + 1] + 1);
            common[i * wide + j] = tokens_same(&ours->list[i], &theirs->list[j]) ? both
                                   : down > right                                ? down
                                                                                 : right;
        }
}

// The hunk ends before our word `end`; first < 0: there is none.
static void add(Hunks *hunks, const Words *ours, int first, int end) {
    if (first < 0)
        return;
    if (hunks->count == HUNKS_MAX) {
        hunks->unknown = true;
        return;
    }
    const int most = ours->count - 1;
    const int low = first < end ? first : first > 0 ? first - 1 : 0;
    const int high = first < end ? end - 1 : end < most ? end : most;
    hunks->list[hunks->count++] = (Hunk){first, end, ours->lines[low], ours->lines[high]};
}

static void walk(Hunks *hunks, const uint16_t *common, const Words *ours, const Words *theirs) {
    const int wide = theirs->count + 1;
    int i = 0, j = 0, first = -1;
    while (i < ours->count || j < theirs->count) {
        const bool both = i < ours->count && j < theirs->count;
        if (both && tokens_same(&ours->list[i], &theirs->list[j])) {
            add(hunks, ours, first, i);
            first = -1;
            i++;
            j++;
            continue;
        }
        first = first < 0 ? i : first;
        if (j == theirs->count || (both && common[(i + 1) * wide + j] >= common[i * wide + j + 1]))
            i++;
        else
            j++;
    }
    add(hunks, ours, first, i);
}

void hunks_find(Hunks *hunks, TextPart theirs, TextPart ours) {
    Words *words = calloc(2, sizeof *words);
    uint16_t *common = NULL;
    *hunks = (Hunks){0};
    if (words) {
        read_words(&words[0], ours);
        read_words(&words[1], theirs);
    }
    if (words && !words[0].too_many && !words[1].too_many && words[0].count > 0)
        common = calloc((size_t)(words[0].count + 1) * (size_t)(words[1].count + 1), sizeof *common);
    hunks->unknown = !common;
    if (common) {
        measure(common, &words[0], &words[1]);
        walk(hunks, common, &words[0], &words[1]);
    }
    free(common);
    free(words);
}

static bool meet(const Hunk *a, const Hunk *b) {
    if (a->first == a->end && b->first == b->end)
        return a->first == b->first;
    return a->first < b->end && b->first < a->end;
}

bool hunks_meet(const Hunks *a, const Hunks *b) {
    bool any = a->unknown || b->unknown;
    for (int i = 0; i < a->count && !any; i++)
        for (int k = 0; k < b->count && !any; k++)
            any = meet(&a->list[i], &b->list[k]);
    return any;
}
