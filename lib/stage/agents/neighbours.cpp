#include "lib/stage/agents/neighbours.h"

#include <algorithm>
#include <cmath>

namespace claque::stage
{

double Neighbours::distance_m(const double a[3], const double b[3]) const
{
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return std::sqrt(x * x + y * y + z * z) * metres_per_unit_;
}

int64_t Neighbours::cell_of(double coordinate) const
{
    return static_cast<int64_t>(std::floor(std::clamp(coordinate * metres_per_unit_ / cell_m, -1e9, 1e9)));
}

uint64_t Neighbours::key_of(int64_t x, int64_t z)
{
    return (static_cast<uint64_t>(x) << 32) ^ (static_cast<uint64_t>(z) & 0xffffffffu);
}

void Neighbours::place(uint32_t agent, uint32_t agent_class, const double position[3])
{
    if (rows_.size() <= agent) rows_.resize(agent + 1);
    const uint64_t cell = key_of(cell_of(position[0]), cell_of(position[2]));
    if (!rows_[agent].is_placed || rows_[agent].cell != cell) {
        cells_[cell].push_back(agent);  // the last step that may fail
        remove(agent);
    }
    Row &row = rows_[agent];
    row.cell = cell, row.agent_class = agent_class, row.is_placed = true;
    std::copy(position, position + 3, row.position);
}

void Neighbours::remove(uint32_t agent)
{
    if (agent >= rows_.size() || !rows_[agent].is_placed) return;
    std::vector<uint32_t> &cell = cells_[rows_[agent].cell];
    *std::find(cell.begin(), cell.end(), agent) = cell.back();
    cell.pop_back();
    rows_[agent].is_placed = false;
}

template <class Body>
void Neighbours::each_near(const double point[3], double radius_m, const Body &body) const
{
    const double reach = radius_m / metres_per_unit_;
    const int64_t x0 = cell_of(point[0] - reach), x1 = cell_of(point[0] + reach);
    const int64_t z0 = cell_of(point[2] - reach), z1 = cell_of(point[2] + reach);
    const auto visit = [&](uint32_t agent) {
        const double distance = distance_m(rows_[agent].position, point);
        if (distance <= radius_m) body(agent, distance);
    };
    if (double(x1 - x0 + 1) * double(z1 - z0 + 1) > double(rows_.size())) {  // fewer agents than cells
        for (uint32_t agent = 0; agent < rows_.size(); ++agent)
            if (rows_[agent].is_placed) visit(agent);
        return;
    }
    for (int64_t x = x0; x <= x1; ++x)
        for (int64_t z = z0; z <= z1; ++z) {
            const auto cell = cells_.find(key_of(x, z));
            if (cell == cells_.end()) continue;
            for (const uint32_t agent : cell->second) visit(agent);
        }
}

void Neighbours::within(const double point[3], double radius_m, uint32_t agent_class, std::vector<Found> &out) const
{
    out.clear();
    each_near(point, radius_m, [&](uint32_t agent, double distance_m) {
        if (agent_class == none || rows_[agent].agent_class == agent_class) out.push_back({agent, distance_m});
    });
    std::sort(out.begin(), out.end(), [](const Found &a, const Found &b) { return a.agent < b.agent; });
}

Neighbours::Found Neighbours::nearest(const double point[3], uint32_t agent_class, uint32_t except) const
{
    for (double radius_m = cell_m;; radius_m *= 2) {
        Found found{none, INFINITY};
        each_near(point, std::min(radius_m, reach_m), [&](uint32_t agent, double distance_m) {
            if (agent == except || rows_[agent].agent_class != agent_class) return;
            if (distance_m < found.distance_m || (distance_m == found.distance_m && agent < found.agent))
                found = {agent, distance_m};
        });
        if (found.agent != none || radius_m >= reach_m) return found;
    }
}

}  // namespace claque::stage
