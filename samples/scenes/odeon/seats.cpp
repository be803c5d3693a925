// Seats on circular rows, one wedge at a time between gangways.
#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/odeon/theatre.h"

namespace scenes
{
namespace
{

// Hips stay square on the stone: sitters turn from the centre of the orchestra towards the stage by at most this
// angle.
constexpr double greatest_turn_deg = 6;

// Turns towards the centre of the stage's front, as far as is possible on a seat that faces the centre of the
// orchestra.
void face_the_stage(Seat &seat, double stage_z)
{
    const double out = std::sqrt(seat.x * seat.x + seat.z * seat.z);
    const double inward_x = -seat.x / out, inward_z = -seat.z / out;
    const double to_x = -seat.x, to_z = stage_z - seat.z, distance = std::sqrt(to_x * to_x + to_z * to_z);
    double s = (inward_z * to_x - inward_x * to_z) / distance, c = (inward_x * to_x + inward_z * to_z) / distance;
    const double most = std::sin(greatest_turn_deg * radians);
    if (std::abs(s) > most || c < 0) {
        s = s < 0 ? -most : most;
        c = std::cos(greatest_turn_deg * radians);
    }
    seat.facing_x = inward_x * c + inward_z * s;
    seat.facing_z = inward_z * c - inward_x * s;
}

}  // namespace

std::vector<Wedge> wedges_of(const Theatre &theatre, size_t row_number)
{
    const SeatRow &row = theatre.rows[row_number];
    std::vector<Wedge> cuts;
    for (const Gangway &gangway : theatre.gangways) {
        if (row_number < gangway.first_row || row_number > gangway.last_row) continue;
        const double half = gangway.width_m / 2 / row.radius_m / radians;
        cuts.push_back({gangway.at_deg - half, gangway.at_deg + half});
    }
    std::sort(cuts.begin(), cuts.end(), [](const Wedge &a, const Wedge &b) { return a.first_deg < b.first_deg; });
    std::vector<Wedge> wedges;
    double from = row.first_deg;
    for (const Wedge &cut : cuts) {
        if (cut.first_deg > from) wedges.push_back({from, std::min(cut.first_deg, row.last_deg)});
        from = std::max(from, cut.last_deg);
    }
    if (from < row.last_deg) wedges.push_back({from, row.last_deg});
    return wedges;
}

std::vector<Seat> seats_of(const Theatre &theatre)
{
    std::vector<Seat> seats;
    for (size_t number = 0; number < theatre.rows.size(); ++number) {
        const SeatRow &row = theatre.rows[number];
        for (const Wedge &wedge : wedges_of(theatre, number)) {
            const double width_deg = theatre.seat_width_m / row.radius_m / radians;
            const int count = static_cast<int>((wedge.last_deg - wedge.first_deg) / width_deg + 1e-9);
            const double each_deg = count > 0 ? (wedge.last_deg - wedge.first_deg) / count : 0;  // spare room is shared
            for (int i = 0; i < count; ++i) {
                Seat seat;
                seat.row = number;
                seat.angle_deg = wedge.first_deg + (i + 0.5) * each_deg;
                seat.x = row.radius_m * std::sin(seat.angle_deg * radians);
                seat.y = row.seat_y_m;
                seat.z = -row.radius_m * std::cos(seat.angle_deg * radians);
                seat.step_y = row.step_y_m;
                face_the_stage(seat, theatre.stage.front_z_m);
                seats.push_back(seat);
            }
        }
    }
    return seats;
}

}  // namespace scenes
