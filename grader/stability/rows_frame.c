// Where the map ends: its sides, its far plane, and what lies behind the light.
#include "row.h"

const Row rows_frame[] = {
    {0},
};
