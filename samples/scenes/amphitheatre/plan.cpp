#include "samples/scenes/amphitheatre/plan.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "samples/scenes/angles.h"
#include "samples/scenes/check.h"

namespace scenes::amphitheatre
{
namespace
{

constexpr double walkway_m = 1.2;      // of the walkways between tiers
constexpr double ledge_m = 0.45;       // under the feet of the first row above a wall
constexpr double podium_walk_m = 1.3;  // behind the parapet of the podium
constexpr double greatest_turn = 0.1;  // of a sitter from the normal towards the middle of the arena, radians

// Of the walls behind the walkways, in the order of the tiers; the last is that of the gallery on top.
constexpr double walls_m[tier_count] = {1.2, 1.1, 3.0, 3.2, 6.2};

std::vector<TierPlan> tier_plans(double seat_share)
{
    //                  rows  out depth floor rise seat  stairs            openings
    std::vector<TierPlan> tiers = {
        {Tier::podium, 4, 0, 0.86, 0, 0.43, 0.70, 5, 2.5, 1.0, 0, 0, 0},
        {Tier::primum, 12, 0, 0.70, 0, 0.43, 0.46, 5, 2.5, 1.0, 5, 5, 4},
        {Tier::imum, 22, 0, 0.67, 0, 0.44, 0.37, 2.5, 2.5, 0.9, 5, 3.75, 8},
        {Tier::summum, 10, 0, 0.66, 0, 0.47, 0.37, 2.5, 1.25, 0.9, 5, 5, 3},
        {Tier::ligneis, 11, 0, 0.62, 0, 0.48, 0.375, 2.5, 2.5, 0.8, 0, 0, 0},
    };
    double out = podium_walk_m, level = podium_m;
    for (TierPlan &tier : tiers) {
        tier.out_m = out;
        tier.floor_m = level;
        tier.seat_m *= seat_share;
        out += static_cast<double>(tier.rows) * tier.depth_m + walkway_m + ledge_m;
        level += static_cast<double>(tier.rows) * tier.rise_m + walls_m[static_cast<size_t>(tier.tier)];
    }
    return tiers;
}

// Middles of things that repeat every so many bays.
std::vector<double> repeated(double first, double every)
{
    std::vector<double> bays;
    for (double bay = first; bay < bay_count + first - 1e-9; bay += every) bays.push_back(bay);
    return bays;
}

}  // namespace

Plan::Plan(double seat_share)
    : oval_(arena_long_m, arena_short_m), tiers_(tier_plans(seat_share)), seat_share_(seat_share)
{
    for (const TierPlan &tier : tiers_) {
        for (size_t i = 0; i < tier.rows; ++i) {
            const double k = static_cast<double>(i);
            rows_.push_back({tier.tier, i, tier.out_m + k * tier.depth_m, tier.depth_m,
                             tier.floor_m + (k + 1) * tier.rise_m, tier.floor_m + k * tier.rise_m});
        }
        const double behind = tier.out_m + static_cast<double>(tier.rows) * tier.depth_m;
        const double level = tier.floor_m + static_cast<double>(tier.rows) * tier.rise_m;
        walkways_.push_back({behind, behind + walkway_m, level, level + walls_m[static_cast<size_t>(tier.tier)]});
    }
}

double Plan::turn_of(double bay) const
{
    return oval_.turn_at(bay / bay_count * oval_.perimeter(building_m), building_m);
}

std::vector<double> Plan::stairs_of(size_t row) const
{
    const TierPlan &tier = tiers_[static_cast<size_t>(rows_[row].tier)];
    return repeated(tier.stairs_first, tier.stairs_every);
}

std::vector<double> Plan::openings_of(size_t row) const
{
    const Row &r = rows_[row];
    const TierPlan &tier = tiers_[static_cast<size_t>(r.tier)];
    if (!(tier.openings_every > 0) || r.number < tier.opening_row || r.number >= tier.opening_row + opening_rows)
        return {};
    return repeated(tier.openings_first, tier.openings_every);
}

std::vector<Stretch> Plan::stretches_of(size_t number) const
{
    const Row &row = rows_[number];
    const TierPlan &tier = tiers_[static_cast<size_t>(row.tier)];
    std::vector<Stretch> cuts;
    const auto cut = [&](double turn, double half_m) {
        const double half = half_m / oval_.radius(turn, row.out_m);
        cuts.push_back({turn - half, turn + half});
    };
    for (const double bay : stairs_of(number)) cut(turn_of(bay), tier.stairs_m / 2);
    for (const double bay : openings_of(number)) cut(turn_of(bay), opening_m / 2);
    // Boxes of honour at the ends of the short axis take the place of the senators' chairs there.
    if (row.tier == Tier::podium)
        for (const double turn : {two_pi / 4, 3 * two_pi / 4}) cut(turn, box_half_m);
    std::sort(cuts.begin(), cuts.end(), [](const Stretch &a, const Stretch &b) { return a.first < b.first; });
    std::vector<Stretch> left;
    for (size_t i = 0; i < cuts.size(); ++i) {
        const double next = i + 1 < cuts.size() ? cuts[i + 1].first : cuts[0].first + two_pi;
        if (next > cuts[i].last) left.push_back({cuts[i].last, next});
    }
    return left;
}

std::vector<Seat> Plan::seats() const
{
    std::vector<Seat> all;
    for (size_t number = 0; number < rows_.size(); ++number) {
        const Row &row = rows_[number];
        const double wide = tiers_[static_cast<size_t>(row.tier)].seat_m;
        for (const Stretch &stretch : stretches_of(number)) {
            const double from = oval_.length(stretch.first, row.out_m), to = oval_.length(stretch.last, row.out_m);
            const int count = static_cast<int>((to - from) / wide + 1e-9);
            for (int i = 0; i < count; ++i) {
                Seat seat = {};
                seat.row = number;
                seat.turn = oval_.turn_at(from + (i + 0.5) * (to - from) / count, row.out_m);
                const Spot spot = oval_.at(seat.turn, row.out_m);
                seat.x = spot.x, seat.z = spot.z, seat.y = row.seat_y_m, seat.step_y = row.step_y_m;
                const double away = std::sqrt(spot.x * spot.x + spot.z * spot.z);
                const double aside = (-spot.out_x * -spot.z / away) - (-spot.out_z * -spot.x / away);
                const double turn = std::clamp(aside, -greatest_turn, greatest_turn);
                const double c = std::sqrt(1 - turn * turn);
                seat.facing_x = -spot.out_x * c + spot.out_z * turn;
                seat.facing_z = -spot.out_z * c - spot.out_x * turn;
                all.push_back(seat);
            }
        }
    }
    return all;
}

Plan plan_for(uint32_t people)
{
    if (people > most_people)
        throw Failure("the amphitheatre holds at most " + std::to_string(most_people) + " people, not " +
                      std::to_string(people));
    double share = 1;
    for (;; share *= 0.985) {
        const Plan plan(share);
        if (plan.seats().size() >= people) return plan;
    }
}

}  // namespace scenes::amphitheatre
