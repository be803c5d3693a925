#include "samples/processes/tile_borders.h"

#include <algorithm>
#include <cmath>

namespace processes
{

TileBorders::TileBorders(int width_px, int count) : width_px_(width_px)
{
    count = std::clamp(count, 1, width_px);
    for (int i = 0; i < count; ++i)
        tiles_.push_back({static_cast<int>(static_cast<long long>(width_px) * i / count),
                          static_cast<int>(static_cast<long long>(width_px) * (i + 1) / count)});
}

void TileBorders::follow(const std::vector<double> &costs)
{
    const size_t count = tiles_.size();
    double sum = 0;
    for (size_t i = 0; i < count && i < costs.size(); ++i) sum += costs[i];
    if (costs.size() != count || !(sum > 0) || !std::isfinite(sum)) return;
    // Border b is where a share b / count of the cost lies to the left.
    std::vector<int> borders = {0};
    double before = 0;
    size_t tile = 0;
    for (size_t b = 1; b < count; ++b) {
        const double wanted = sum * static_cast<double>(b) / static_cast<double>(count);
        while (tile + 1 < count && before + costs[tile] < wanted) before += costs[tile++];
        const double width = tiles_[tile].x1 - tiles_[tile].x0;
        const double within = costs[tile] > 0 ? (wanted - before) / costs[tile] * width : 0;
        const int border = tiles_[tile].x0 + static_cast<int>(std::lround(std::clamp(within, 0.0, width)));
        // At least one column for each tile.
        borders.push_back(std::clamp(border, borders.back() + 1, width_px_ - static_cast<int>(count - b)));
    }
    borders.push_back(width_px_);
    for (size_t i = 0; i < count; ++i) tiles_[i] = {borders[i], borders[i + 1]};
}

}  // namespace processes
