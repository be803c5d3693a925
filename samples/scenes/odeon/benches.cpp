#include "samples/scenes/odeon/benches.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/odeon/floor.h"

namespace scenes
{
namespace
{

constexpr double before_seats_m = 0.18;  // of the middle of the strip on which people walk

// The gangway at an end of a wedge.
const Gangway *gangway_at(const Theatre &theatre, size_t row, double end_deg)
{
    for (const Gangway &gangway : theatre.gangways) {
        const double half = gangway.width_m / 2 / theatre.rows[row].radius_m / radians;
        if (row >= gangway.first_row && row <= gangway.last_row && std::abs(gangway.at_deg - end_deg) < 1.01 * half)
            return &gangway;
    }
    return nullptr;
}

Bench bench_of(const Theatre &theatre, size_t row, const Gangway &gangway, std::vector<size_t> seats)
{
    Bench bench;
    bench.row = row;
    bench.social_class = theatre.rows[row].social_class;
    bench.seats = std::move(seats);
    bench.gangway_deg = gangway.at_deg;
    const double radius = theatre.rows[row].radius_m - before_seats_m, angle = gangway.at_deg * radians;
    const double y = ramp_y(treads_of(theatre, gangway), radius);
    bench.entry = {radius * std::sin(angle), y, -radius * std::cos(angle)};
    bench.climb_m = std::hypot(radius - theatre.orchestra_radius_m, y);
    return bench;
}

}  // namespace

std::vector<Bench> benches_of(const Theatre &theatre, const std::vector<Seat> &seats)
{
    std::vector<Bench> benches;
    for (size_t row = 0; row < theatre.rows.size(); ++row) {
        if (theatre.rows[row].social_class.empty()) continue;
        for (const Wedge &wedge : wedges_of(theatre, row)) {
            std::vector<size_t> own;  // by ascending angle
            for (size_t i = 0; i < seats.size(); ++i)
                if (seats[i].row == row && seats[i].angle_deg > wedge.first_deg && seats[i].angle_deg < wedge.last_deg)
                    own.push_back(i);
            const Gangway *first = gangway_at(theatre, row, wedge.first_deg);
            const Gangway *last = gangway_at(theatre, row, wedge.last_deg);
            const auto middle = own.begin() + static_cast<ptrdiff_t>(first && last ? own.size() / 2
                                                                     : first       ? own.size()
                                                                                   : 0);
            std::vector<size_t> lower(own.begin(), middle), upper(middle, own.end());
            std::reverse(lower.begin(), lower.end());
            if (first && !lower.empty()) benches.push_back(bench_of(theatre, row, *first, lower));
            if (last && !upper.empty()) benches.push_back(bench_of(theatre, row, *last, upper));
        }
    }
    return benches;
}

}  // namespace scenes
