// Agents by place: cells of a grid over x and z. The one function through which the stage asks for neighbours is
// within(); nearest() is built on it.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "lib/stage/machine/expression.h"

namespace claque::stage
{

class Neighbours
{
public:
    explicit Neighbours(double metres_per_unit) : metres_per_unit_(metres_per_unit) {}

    void place(uint32_t agent, uint32_t agent_class, const double position[3]);
    void remove(uint32_t agent);

    struct Found {
        uint32_t agent;
        double distance_m;
    };
    // Agents within a distance of a point, of one class or (none) of any, in the order of agents.
    void within(const double point[3], double radius_m, uint32_t agent_class, std::vector<Found> &out) const;
    // The nearest one but `except` within 50 m; agent none: there is none.
    Found nearest(const double point[3], uint32_t agent_class, uint32_t except) const;
    // Its place; NULL: there is none.
    const double *nearest_place(const double point[3], uint32_t agent_class, uint32_t except) const
    {
        const uint32_t found = nearest(point, agent_class, except).agent;
        return found == none ? nullptr : rows_[found].position;
    }
    double distance_m(const double a[3], const double b[3]) const;

    static constexpr double reach_m = 50;

private:
    struct Row {
        uint64_t cell = 0;
        uint32_t agent_class = 0;
        bool is_placed = false;
        double position[3] = {};
    };
    static constexpr double cell_m = 4;
    int64_t cell_of(double coordinate) const;
    static uint64_t key_of(int64_t x, int64_t z);
    template <class Body>
    void each_near(const double point[3], double radius_m, const Body &body) const;

    double metres_per_unit_;
    std::vector<Row> rows_;  // by agent
    std::unordered_map<uint64_t, std::vector<uint32_t>> cells_;
};

}  // namespace claque::stage
