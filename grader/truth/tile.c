#include "tile.h"

#include <pthread.h>
#include <stdatomic.h>

typedef struct Queue {
    int width, height, count;
    void (*work)(const Tile *tile, void *context);
    void *context;
    atomic_int next;
} Queue;

static Tile make_tile(const Queue *queue, int index) {
    int across = (queue->width + TILE_SIDE - 1) / TILE_SIDE;
    Tile tile = {.index = index};
    for (int i = 0; i < TILE_LANES; i++) {
        int x = index % across * TILE_SIDE + i % TILE_SIDE, y = index / across * TILE_SIDE + i / TILE_SIDE;
        tile.inside[i] = x < queue->width && y < queue->height ? -1 : 0;
        tile.column[i] = x;
        tile.row[i] = y;
        tile.pixel[i] = tile.inside[i] ? (size_t)y * (size_t)queue->width + (size_t)x : 0;
    }
    return tile;
}

static void *work_off(void *data) {
    Queue *queue = data;
    for (int i = atomic_fetch_add(&queue->next, 1); i < queue->count; i = atomic_fetch_add(&queue->next, 1)) {
        Tile tile = make_tile(queue, i);
        queue->work(&tile, queue->context);
    }
    return NULL;
}

void tile_each(int width, int height, void (*work)(const Tile *tile, void *context), void *context) {
    int across = (width + TILE_SIDE - 1) / TILE_SIDE, down = (height + TILE_SIDE - 1) / TILE_SIDE;
    Queue queue = {
        .width = width, .height = height, .count = across * down, .work = work, .context = context};
    pthread_t threads[TRUTH_THREADS - 1];
    int started = 0;
    // A thread that cannot be started only costs time: the others take its tiles.
    while (started < TRUTH_THREADS - 1 && pthread_create(&threads[started], NULL, work_off, &queue) == 0)
        started++;
    work_off(&queue);
    for (int i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
}
