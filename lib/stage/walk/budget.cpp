#include "lib/stage/walk/budget.h"

#include <algorithm>
#include <cmath>

namespace claque::walk
{

namespace
{

constexpr uint32_t max_tiles = 16384;
constexpr uint64_t max_tile_cells = 12000000;

// The tiles that a triangle touches, and the cells of one that its box covers.
struct Cover {
    int first_column, last_column, first_row, last_row;
};

Cover cover_of(const Ground &ground, const Grid &grid, size_t triangle)
{
    float min_x = INFINITY, max_x = -INFINITY, min_z = INFINITY, max_z = -INFINITY;
    for (size_t k = 0; k < 3; ++k) {
        const float *v = ground.vertices.data() + 3 * size_t(ground.triangles[3 * triangle + k]);
        min_x = std::min(min_x, v[0]), max_x = std::max(max_x, v[0]);
        min_z = std::min(min_z, v[2]), max_z = std::max(max_z, v[2]);
    }
    const float margin = static_cast<float>(grid.border) * ground.cell;
    const auto tile = [&](float x, float from, int count) {
        return std::clamp(static_cast<int>(std::floor((x - from) / grid.tile_size)), 0, count - 1);
    };
    return {tile(min_x - margin, ground.min[0], grid.columns), tile(max_x + margin, ground.min[0], grid.columns),
            tile(min_z - margin, ground.min[2], grid.rows), tile(max_z + margin, ground.min[2], grid.rows)};
}

uint64_t cells_in_tile(const Ground &ground, const Grid &grid, size_t triangle, float x0, float z0)
{
    double size[2];
    for (size_t axis = 0; axis < 2; ++axis) {
        float min = INFINITY, max = -INFINITY;
        for (size_t k = 0; k < 3; ++k) {
            const float v = ground.vertices[3 * size_t(ground.triangles[3 * triangle + k]) + 2 * axis];
            min = std::min(min, v), max = std::max(max, v);
        }
        const double from = double(axis == 0 ? x0 : z0), to = from + double(grid.width) * double(ground.cell);
        size[axis] = std::min(double(max), to) - std::max(double(min), from);
        size[axis] = std::max(0.0, std::floor(size[axis] / double(ground.cell))) + 2;
    }
    return static_cast<uint64_t>(size[0] * size[1]);
}

}  // namespace

Grid grid_of(const Ground &ground)
{
    Grid grid{};
    const float radius = std::ceil(ground.radius / ground.cell - 0.001f);
    grid.border = static_cast<int>(radius) + 3;
    grid.width = tile_cells + 2 * grid.border;
    grid.tile_size = static_cast<float>(tile_cells) * ground.cell;
    const double columns = std::ceil(double(ground.max[0] - ground.min[0]) / double(grid.tile_size));
    const double rows = std::ceil(double(ground.max[2] - ground.min[2]) / double(grid.tile_size));
    grid.columns = static_cast<int>(std::max(1.0, columns)), grid.rows = static_cast<int>(std::max(1.0, rows));
    if (std::max(1.0, columns) * std::max(1.0, rows) > max_tiles)
        fail(CLQ_LIMIT,
             "the ground to walk on is %.6g by %.6g m: with cells of %g m, %u tiles of %g m are possible; larger "
             "cells help",
             double(ground.max[0] - ground.min[0]), double(ground.max[2] - ground.min[2]), double(ground.cell),
             max_tiles, double(grid.tile_size));
    return grid;
}

std::vector<std::vector<int>> share_out(const Ground &ground, const Grid &grid)
{
    std::vector<std::vector<int>> tiles(size_t(grid.columns) * size_t(grid.rows));
    std::vector<uint64_t> cells(tiles.size());
    uint64_t sum = tiles.size() * uint64_t(grid.width) * uint64_t(grid.width) / 4;
    const float margin = static_cast<float>(grid.border) * ground.cell;
    for (size_t i = 0; i < ground.triangles.size() / 3; ++i) {
        const Cover cover = cover_of(ground, grid, i);
        for (int row = cover.first_row; row <= cover.last_row; ++row)
            for (int column = cover.first_column; column <= cover.last_column; ++column) {
                const size_t tile = size_t(row) * size_t(grid.columns) + size_t(column);
                const uint64_t count =
                    cells_in_tile(ground, grid, i, ground.min[0] + static_cast<float>(column) * grid.tile_size - margin,
                                  ground.min[2] + static_cast<float>(row) * grid.tile_size - margin);
                sum += count, cells[tile] += count;
                if (sum > ground.max_cells || cells[tile] > max_tile_cells)
                    fail(CLQ_LIMIT,
                         "the triangles to walk on cover more than %llu cells of %g m (up to triangle %zu of %zu): "
                         "larger cells or max_cells help",
                         static_cast<unsigned long long>(std::min(ground.max_cells, max_tile_cells)),
                         double(ground.cell), i, ground.triangles.size() / 3);
                for (size_t k = 0; k < 3; ++k) tiles[tile].push_back(ground.triangles[3 * i + k]);
            }
    }
    return tiles;
}

}  // namespace claque::walk
