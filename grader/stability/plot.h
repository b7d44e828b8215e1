// The curves as SVG, by gnuplot.
#pragma once

#include "stability/row.h"

#include <stdbool.h>

enum { PLOT_NAME = 64 };

// "stability-07.svg": the file of a row's figures.
void plot_name(char name[PLOT_NAME], const Row *row);

// "stability-07-1.svg": the file of its first figure (0) alone.
void plot_figure_name(char name[PLOT_NAME], const Row *row, int figure);

// Draws the rows' figures into `folder`, beside the script stability.gp that draws them. False with a
// message.
bool plot_all(const RowResult *results, int count, const char *folder);
