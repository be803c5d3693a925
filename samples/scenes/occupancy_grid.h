// The positions that are taken, so that people do not overlap. A grid of square cells makes it fast for thousands.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace scenes
{

class OccupancyGrid
{
public:
    // True if no position nearer than `distance` [0, 2] metres is taken.
    bool free(double x, double z, double distance) const
    {
        for (int64_t i = cell(x) - 1; i <= cell(x) + 1; ++i)
            for (int64_t k = cell(z) - 1; k <= cell(z) + 1; ++k) {
                const auto found = cells_.find(key(i, k));
                if (found == cells_.end()) continue;
                for (const Point &p : found->second)
                    if ((p.x - x) * (p.x - x) + (p.z - z) * (p.z - z) < distance * distance) return false;
            }
        return true;
    }
    void take(double x, double z) { cells_[key(cell(x), cell(z))].push_back({x, z}); }

private:
    struct Point {
        double x, z;
    };
    static int64_t cell(double metres) { return static_cast<int64_t>(std::floor(metres * 0.5)); }
    static uint64_t key(int64_t i, int64_t k)
    {
        return static_cast<uint64_t>(i) * 0x9e3779b97f4a7c15u + static_cast<uint64_t>(k);
    }
    std::unordered_map<uint64_t, std::vector<Point>> cells_;
};

}  // namespace scenes
