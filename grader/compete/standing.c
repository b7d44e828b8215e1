#include "compete/standing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void standing_cost(Standing *standing) {
    standing->cost = round(10 * (standing->taps + standing->fragments + standing->texels)) / 10;
}

static int by_cost(const void *a, const void *b) {
    const Standing *one = a, *other = b;
    if (one->ranked != other->ranked)
        return one->ranked ? -1 : 1;
    if (one->ranked && one->cost != other->cost)
        return one->cost < other->cost ? -1 : 1;
    return strcmp(one->name, other->name);
}

void standing_sort(Standing *standings, int count) {
    qsort(standings, (size_t)count, sizeof *standings, by_cost);
    for (int i = 0; i < count; i++) {
        const bool equal = i > 0 && standings[i - 1].cost == standings[i].cost;
        standings[i].place = !standings[i].ranked ? 0 : equal ? standings[i - 1].place : i + 1;
    }
}
