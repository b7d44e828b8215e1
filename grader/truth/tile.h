// The pixels of a picture in tiles of 4 x 4, and threads that share them.
#pragma once

#include "truth/truth.h"

enum { TILE_SIDE = 4, TILE_LANES = TILE_SIDE * TILE_SIDE };

// One tile's pixels; lanes beyond the picture are not inside.
typedef struct Tile {
    int index;                           // unique in the picture
    _Alignas(64) int inside[TILE_LANES]; // -1 or 0, as Embree wants it
    int column[TILE_LANES], row[TILE_LANES];
    size_t pixel[TILE_LANES];
} Tile;

// Calls `work` for each of the rows 0..count - 1, from TRUTH_THREADS threads in no fixed order; each row
// once.
void tile_each_row(int count, void (*work)(int row, void *context), void *context);

// Calls `work` for each tile of the picture, from TRUTH_THREADS threads in no fixed order; each tile once.
void tile_each(int width, int height, void (*work)(const Tile *tile, void *context), void *context);
