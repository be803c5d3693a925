// How the ground is cut into tiles, and what they may take.
#pragma once

#include "lib/stage/walk/mesh.h"

namespace claque::walk
{

constexpr int tile_cells = 128;

struct Grid {
    int border, width;  // cells
    float tile_size;
    int columns, rows;
};

// Throws stage::Error (LIMIT).
Grid grid_of(const Ground &ground);
// The triangles of each tile, row by row, counted against the budget before any cell exists. Throws stage::Error
// (LIMIT).
std::vector<std::vector<int>> share_out(const Ground &ground, const Grid &grid);

}  // namespace claque::walk
