#include "samples/scenes/amphitheatre/spectators.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/odeon/noise.h"
#include "samples/scenes/odeon/seating.h"
#include "samples/scenes/random.h"

namespace scenes::amphitheatre
{
namespace
{

constexpr double greatest_gaze_deg = 8;  // of a body on its seat, from the seat's own direction
constexpr double head_m = 0.75;          // of a sitter above its seat

float rounded_down(double speed) { return std::nextafter(static_cast<float>(speed), 0.0f); }

// How many people each tier gets, in proportion to its seats; the largest remainders are rounded up.
std::array<size_t, tier_count> shares(const std::array<size_t, tier_count> &seats, size_t all, uint32_t people)
{
    std::array<size_t, tier_count> shares = {};
    std::vector<std::pair<size_t, size_t>> remainders;
    size_t left = people;
    for (size_t t = 0; t < tier_count; ++t) {
        shares[t] = seats[t] * people / all;
        left -= shares[t];
        remainders.push_back({seats[t] * people % all, t});
    }
    std::stable_sort(remainders.begin(), remainders.end(), [](auto &a, auto &b) { return a.first > b.first; });
    for (size_t i = 0; i < left; ++i) ++shares[remainders[i].second];
    return shares;
}

size_t kind_of(Tier tier, uint64_t seed, size_t seat)
{
    const std::vector<SocialClass> &kinds = orders_of(tier);
    double at = random_unit(seed, seat, Purpose::group_size);
    for (size_t k = 0; k + 1 < kinds.size(); ++k) {
        if (at < kinds[k].share) return k;
        at -= kinds[k].share;
    }
    return kinds.size() - 1;
}

// A turn towards a place in the arena: neighbours look at things that are near each other, with a rest of their own.
double gaze_deg(const Seat &seat, uint64_t seed, size_t person)
{
    return greatest_gaze_deg * std::clamp(1.5 * gradient_noise(seed + 7, seat.x / 9, seat.z / 9) +
                                              random_between(seed, person, Purpose::heading, -0.5, 0.5),
                                          -1.0, 1.0);
}

clq_transform placed(const Seat &seat, double turn_deg, float scale)
{
    scenes::Seat stone;
    stone.x = seat.x, stone.y = seat.y, stone.z = seat.z, stone.step_y = seat.step_y;
    stone.facing_x = seat.facing_x, stone.facing_z = seat.facing_z;
    return sit_down(stone, turn_deg, scale);
}

std::vector<clq_hsb_range> in_light(std::vector<clq_hsb_range> ranges, double light)
{
    for (clq_hsb_range &range : ranges) {
        range.brightness_min *= static_cast<float>(light);
        range.brightness_max *= static_cast<float>(light);
    }
    return ranges;
}

}  // namespace

std::vector<Sitter> seat_people(const Plan &plan, uint32_t people, uint64_t seed)
{
    const std::vector<Seat> seats = plan.seats();
    std::array<std::vector<std::pair<uint64_t, size_t>>, tier_count> theirs;
    std::array<size_t, tier_count> counts = {};
    for (size_t i = 0; i < seats.size(); ++i) {
        const size_t tier = static_cast<size_t>(plan.rows()[seats[i].row].tier);
        theirs[tier].push_back({random_bits(seed, i, Purpose::seat), i});
        ++counts[tier];
    }
    const std::array<size_t, tier_count> wanted = shares(counts, seats.size(), people);
    std::vector<Sitter> sitters;
    sitters.reserve(people);
    for (size_t t = 0; t < tier_count; ++t) {
        std::sort(theirs[t].begin(), theirs[t].end());
        theirs[t].resize(wanted[t]);
        std::sort(theirs[t].begin(), theirs[t].end(), [](auto &a, auto &b) { return a.second < b.second; });
        for (const auto &[order, seat] : theirs[t]) {
            const Tier tier = static_cast<Tier>(t);
            Sitter sitter = {seat, tier, kind_of(tier, seed, seat), 1, {}};
            const bool woman = orders_of(tier)[sitter.kind].character == "patrician";
            sitter.scale = static_cast<float>(woman ? random_between(seed, seat, Purpose::size, 0.87, 0.93)
                                                    : random_between(seed, seat, Purpose::size, 0.92, 1.0));
            sitter.place = placed(seats[seat], gaze_deg(seats[seat], seed, seat), sitter.scale);
            sitters.push_back(sitter);
        }
    }
    return sitters;
}

size_t Figures::find(const std::string &name)
{
    for (size_t i = 0; i < figures_.size(); ++i)
        if (figures_[i].name == name) return i;
    Figure made;
    made.name = name;
    made.tmpl = library_.builtin(name, levels_);
    for (size_t a = 0; a < act_count; ++a) {
        made.clips[a] = clq_template_find_clip(made.tmpl, clip_name(static_cast<Act>(a)));
        clq_clip_info info = clq_clip_info_init();
        check(clq_template_get_clip(made.tmpl, made.clips[a], &info), name);
        made.duration_s[a] = static_cast<double>(info.duration_s);
    }
    figures_.push_back(std::move(made));
    return figures_.size() - 1;
}

std::vector<clq_template *> Figures::templates() const
{
    std::vector<clq_template *> all;
    for (const Figure &figure : figures_) all.push_back(figure.tmpl);
    return all;
}

Spectators::Spectators(Figures &figures, SceneCrowd &crowd, const Plan &plan, const Exposure &exposure, uint32_t people,
                       uint64_t seed)
    : figures_(figures), crowd_(crowd)
{
    std::array<std::vector<std::vector<clq_hsb_range>>, tier_count> palettes;
    std::array<std::vector<size_t>, tier_count> worn;
    for (size_t t = 0; t < tier_count; ++t)
        for (const SocialClass &kind : orders_of(static_cast<Tier>(t))) {
            worn[t].push_back(figures.find(kind.character));
            palettes[t].push_back(ranges_of(figures[worn[t].back()].tmpl, kind));
        }
    for (const Sitter &sitter : seat_people(plan, people, seed)) {
        const size_t t = static_cast<size_t>(sitter.tier), figure = worn[t][sitter.kind];
        Spectator spectator;
        spectator.seed = seed, spectator.person = sitter.seat;
        spectator.x = sitter.place.position[0], spectator.z = sitter.place.position[2];
        spectator.temperament = orders_of(sitter.tier)[sitter.kind].temperament;
        spectator.duration_s = figures[figure].duration_s;
        clq_play still = clq_play_init();
        still.clip = figures[figure].clips[0];
        const Vec3 head = {static_cast<float>(spectator.x), static_cast<float>(sitter.place.position[1] + head_m),
                           static_cast<float>(spectator.z)};
        crowd.enter({figures[figure].tmpl, sitter.place, still}, random_bits(seed, sitter.seat, Purpose::tone),
                    in_light(palettes[t][sitter.kind], exposure.of_person(head)));
        spectators_.push_back(spectator);
        figure_of_.push_back(figure);
    }
    playing_.resize(spectators_.size());
}

void Spectators::act(double time_s)
{
    for (size_t i = 0; i < spectators_.size(); ++i) {
        Playing &now = playing_[i];
        if (now.begin_s <= time_s && time_s < now.end_s) continue;
        now = playing_at(spectators_[i], time_s);
        clq_play play = clq_play_init();
        play.clip = figures_[figure_of_[i]].clips[static_cast<size_t>(now.act)];
        play.start_s = now.begin_s;
        play.speed = rounded_down(now.speed);
        crowd_.play(i, play);
    }
}

}  // namespace scenes::amphitheatre
