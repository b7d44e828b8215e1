#include "truth/tile.h"

#include <pthread.h>
#include <stdatomic.h>

typedef struct Queue {
    int count;
    void (*work)(int row, void *context);
    void *context;
    atomic_int next;
} Queue;

static void *work_off(void *data) {
    Queue *queue = data;
    for (int row; (row = atomic_fetch_add(&queue->next, 1)) < queue->count;)
        queue->work(row, queue->context);
    return NULL;
}

void tile_each_row(int count, void (*work)(int row, void *context), void *context) {
    Queue queue = {.count = count, .work = work, .context = context};
    pthread_t threads[TRUTH_THREADS - 1];
    int started = 0;
    // A thread that cannot be started only costs time: the others take its rows.
    while (started < TRUTH_THREADS - 1 && pthread_create(&threads[started], NULL, work_off, &queue) == 0)
        started++;
    work_off(&queue);
    for (int i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
}

typedef struct Grid {
    int width, height, across; // pixels; tiles
    void (*work)(const Tile *tile, void *context);
    void *context;
} Grid;

static void set_tile(Tile *tile, const Grid *grid, int left, int top) {
    for (int i = 0; i < TILE_LANES; i++) {
        int x = left + i % TILE_SIDE, y = top + i / TILE_SIDE;
        tile->column[i] = x;
        tile->row[i] = y;
        tile->inside[i] = x < grid->width && y < grid->height ? -1 : 0;
        tile->pixel[i] = tile->inside[i] ? (size_t)y * (size_t)grid->width + (size_t)x : 0;
    }
}

static void work_row(int row, void *context) {
    const Grid *grid = context;
    Tile tile;
    for (int column = 0; column < grid->across; column++) {
        tile.index = row * grid->across + column;
        set_tile(&tile, grid, column * TILE_SIDE, row * TILE_SIDE);
        grid->work(&tile, grid->context);
    }
}

void tile_each(int width, int height, void (*work)(const Tile *tile, void *context), void *context) {
    Grid grid = {width, height, (width + TILE_SIDE - 1) / TILE_SIDE, work, context};
    tile_each_row((height + TILE_SIDE - 1) / TILE_SIDE, work_row, &grid);
}
