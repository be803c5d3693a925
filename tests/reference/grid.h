// Which points are near another.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "tests/reference/matrix.h"

namespace claque::reference
{

// Points by the cell they are in; cells as wide as the distance that is asked for.
class Grid
{
public:
    // `points` must outlive the grid.
    Grid(const std::vector<Vec3> &points, double cell) : points_(points), cell_(cell)
    {
        for (size_t i = 0; i < points.size(); ++i) cells_[key(place(points[i]))].push_back(i);
    }

    std::vector<size_t> near(const Vec3 &at) const
    {
        std::vector<size_t> found;
        const auto middle = place(at);
        for (int64_t n = 0; n < 27; ++n) {
            const auto cell =
                cells_.find(key({middle[0] + n % 3 - 1, middle[1] + n / 3 % 3 - 1, middle[2] + n / 9 - 1}));
            if (cell == cells_.end()) continue;
            for (const size_t i : cell->second)
                if (length(points_[i] - at) <= cell_) found.push_back(i);
        }
        return found;
    }

private:
    using Place = std::array<int64_t, 3>;
    Place place(const Vec3 &p) const
    {
        const auto along = [&](double x) { return static_cast<int64_t>(std::floor(x / cell_)); };
        return {along(p.x), along(p.y), along(p.z)};
    }
    // Cells that share a key cost time only: distances are measured.
    static uint64_t key(const Place &p)
    {
        return static_cast<uint64_t>(p[0]) * 73856093u ^ static_cast<uint64_t>(p[1]) * 19349663u ^
               static_cast<uint64_t>(p[2]) * 83492791u;
    }

    const std::vector<Vec3> &points_;
    double cell_;
    std::unordered_map<uint64_t, std::vector<size_t>> cells_;
};

}  // namespace claque::reference
