#include "samples/scenes/odeon/seating.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/odeon/noise.h"
#include "samples/scenes/odeon/validate_theatre.h"
#include "samples/scenes/random.h"
#include "samples/scenes/scene_crowd.h"

namespace scenes
{
namespace
{

constexpr double noise_cell_m = 4.0;     // about six seats
constexpr double feet_to_hips_m = 0.40;  // horizontal, of a sitter of scale 1
// the feet's share of the misfit between a tall or short sitter and the seat; the hips take the rest
constexpr double share_of_feet = 0.45;

// Shares in the proportions of the description; the largest remainders are rounded up.
std::vector<uint32_t> shares(const Theatre &theatre, uint32_t count)
{
    std::vector<uint32_t> shares;
    uint64_t total = 0;
    for (const SocialClass &one : theatre.classes) {
        shares.push_back(one.count);
        total += one.count;
    }
    if (count == 0 || count == total || total == 0) return shares;
    std::vector<std::pair<uint64_t, size_t>> remainders;
    uint32_t left = count;
    for (size_t c = 0; c < shares.size(); ++c) {
        const uint64_t exact = uint64_t(count) * theatre.classes[c].count;
        shares[c] = static_cast<uint32_t>(exact / total);
        left -= shares[c];
        remainders.push_back({exact % total, c});
    }
    std::stable_sort(remainders.begin(), remainders.end(), [](auto &a, auto &b) { return a.first > b.first; });
    for (uint32_t i = 0; i < left; ++i) ++shares[remainders[i].second];
    return shares;
}

float scale_of(const SocialClass &one, uint64_t seed, size_t seat)
{
    const bool woman = one.character == "patrician";
    return static_cast<float>(woman ? random_between(seed, seat, Purpose::size, 0.93, 0.98)
                                    : random_between(seed, seat, Purpose::size, 0.97, 1.03));
}

}  // namespace

double facing_turn_deg(const Theatre &theatre, const Seat &seat, uint64_t seed)
{
    return theatre.facing_noise_deg * gradient_noise(seed, seat.x / noise_cell_m, seat.z / noise_cell_m);
}

clq_transform sit_down(const Seat &seat, double turn_deg, float scale)
{
    const double s = std::sin(turn_deg * radians), c = std::cos(turn_deg * radians);
    const double facing_x = seat.facing_x * c + seat.facing_z * s, facing_z = seat.facing_z * c - seat.facing_x * s;
    const double edge_to_hips = (feet_to_hips_m - seat_edge_to_feet_m) * scale, to_feet = feet_to_hips_m * scale;
    const double spare = seat.y - seat.step_y - sitting_height_m * scale;  // below the hips of short people
    return stand(seat.x - seat.facing_x * edge_to_hips + facing_x * to_feet, seat.step_y + spare * share_of_feet,
                 seat.z - seat.facing_z * edge_to_hips + facing_z * to_feet, facing_x, facing_z, scale);
}

std::vector<Sitter> seat_people(const Theatre &theatre, const std::vector<Seat> &seats, uint32_t count, uint64_t seed)
{
    const std::vector<uint32_t> wanted = shares(theatre, count);
    std::vector<Sitter> people;
    for (size_t c = 0; c < theatre.classes.size(); ++c) {
        const SocialClass &one = theatre.classes[c];
        std::vector<std::pair<uint64_t, size_t>> theirs;
        for (size_t seat = 0; seat < seats.size(); ++seat)
            if (theatre.rows[seats[seat].row].social_class == one.name)
                theirs.push_back({random_bits(seed, seat, Purpose::seat), seat});
        if (wanted[c] > theirs.size())
            throw Failure("an audience of " + std::to_string(count) + " has " + std::to_string(wanted[c]) + " " +
                          one.name + ", and their rows have " + std::to_string(theirs.size()) + " seats");
        std::sort(theirs.begin(), theirs.end());
        theirs.resize(wanted[c]);
        std::sort(theirs.begin(), theirs.end(), [](auto &a, auto &b) { return a.second < b.second; });
        for (const auto &[random_unit, seat] : theirs) {
            Sitter sitter;
            sitter.seat = seat;
            sitter.social_class = c;
            sitter.scale = scale_of(one, seed, seat);
            sitter.place = sit_down(seats[seat], facing_turn_deg(theatre, seats[seat], seed), sitter.scale);
            people.push_back(sitter);
        }
    }
    return people;
}

}  // namespace scenes
