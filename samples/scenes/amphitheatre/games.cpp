#include "samples/scenes/amphitheatre/games.h"

#include <cmath>

#include "samples/scenes/amphitheatre/surround.h"
#include "samples/scenes/angles.h"
#include "samples/scenes/odeon/seating.h"
#include "samples/scenes/random.h"

namespace scenes::amphitheatre
{
namespace
{

constexpr double stride_m = 1.24;  // of two steps of the walk, at scale 1
constexpr double inner_m = -6.4, outer_m = -5.0, rank_m = 2.3;
constexpr double guest_out_m = 2.3, guest_seat_m = 0.43;
constexpr float looked_at = 0.6f;  // the priority of the people that all look at: finer levels
constexpr double south = two_pi / 4, north = 3 * two_pi / 4;

// Sideways from the middle of a box to each guest; the emperor's own place in the middle of the southern one is free.
constexpr double guests_south[] = {-4.2, -3.3, -2.4, -1.5, 1.5, 2.4, 3.3, 4.2};
constexpr double guests_north[] = {-2.8, -1.7, -0.6, 0.6, 1.7, 2.8};

}  // namespace

clq_transform walking(const Plan &plan, size_t walker, double time_s, double metres_per_s, float scale)
{
    const double middle = (inner_m + outer_m) / 2;
    const double along = metres_per_s * time_s - rank_m * static_cast<double>(walker / 2);
    const double turn = plan.oval().turn_at(along, middle);
    const Spot spot = plan.oval().at(turn, walker % 2 == 0 ? inner_m : outer_m);
    return stand(spot.x, 0, spot.z, -spot.out_z, spot.out_x, scale);
}

void build_guest_seats(Masonry &m, const Plan &plan)
{
    const auto seat = [&](double turn, double aside, double half) {
        const double at = turn + aside / plan.oval().radius(turn, guest_out_m);
        m.block(at, half, guest_out_m, guest_out_m + 0.55, box_floor_m, box_floor_m + guest_seat_m,
                {0.95f, 0.80f, 0.50f});
    };
    for (const double aside : guests_south) seat(south, aside, 0.33);
    for (const double aside : guests_north) seat(north, aside, 0.36);
}

Games::Games(Figures &figures, SceneCrowd &crowd, const Plan &plan, const Exposure &exposure, uint64_t seed)
    : figures_(figures), crowd_(crowd), plan_(plan), exposure_(exposure), seed_(seed), first_(crowd.actors().size())
{
    walkers();
    greeters();
    guests();
    add_lit(first_ + walker_count, greeter_count, lit_greeters_);
}

// Those of `count` actors that the sun shines on.
void Games::add_lit(size_t first, size_t count, std::vector<clq_transform> &out) const
{
    for (size_t i = first; i < first + count; ++i) {
        const clq_transform &place = crowd_.places()[i];
        const Vec3 waist = {static_cast<float>(place.position[0]), 1, static_cast<float>(place.position[2])};
        if (exposure_.sun_at(waist) > 0.5) out.push_back(place);
    }
}

void Games::enter(const std::string &character, const clq_transform &place, const char *clip, double speed,
                  size_t person)
{
    clq_template *tmpl = figures_[figures_.find(character)].tmpl;
    clq_play play = clq_play_init();
    play.clip = clq_template_find_clip(tmpl, clip);
    clq_clip_info info = clq_clip_info_init();
    check(clq_template_get_clip(tmpl, play.clip, &info), clip);
    play.speed = static_cast<float>(speed);
    play.phase_s =
        static_cast<float>(random_unit(seed_ + 3, person, Purpose::phase) * static_cast<double>(info.duration_s));
    crowd_.enter({tmpl, place, play});
    check(clq_actor_set_priority(crowd_.crowd(), crowd_.actors().back(), looked_at));
}

// Priests and magistrates first, then gladiators in bright tunics.
void Games::walkers()
{
    metres_per_s_ = stride_m / 1.1 * 0.96;
    for (size_t person = 0; person < walker_count; ++person) {
        const float scale = static_cast<float>(random_between(seed_, person, Purpose::size, 0.95, 1.02));
        enter(person < 12       ? "decurion"
              : person % 3 == 0 ? "citizen"
                                : "plebeian",
              walking(plan_, person, 0, metres_per_s_, scale), "walk", 0.96 / static_cast<double>(scale), person);
    }
}

// Two companies before the emperor's box.
void Games::greeters()
{
    for (size_t i = 0; i < greeter_count; ++i) {
        const size_t company = i / 15, place = i % 15;
        const double x = (company == 0 ? -9.5 : 9.5) + (static_cast<double>(place % 5) - 2) * 1.7,
                     z = 7.5 + static_cast<double>(place / 5) * 1.9;
        const char *clips[] = {"stand_wave", "stand_cheer", "stand", "stand_applaud", "stand_wave"};
        const float scale = static_cast<float>(random_between(seed_, i + 200, Purpose::size, 0.96, 1.04));
        enter(company == 0 ? "plebeian" : "citizen", stand(x, 0, z, -0.1 * x, 18, scale),
              clips[random_bits(seed_, i, Purpose::clip) % 5],
              random_between(seed_, i + 200, Purpose::speed, 0.85, 1.1), i + 200);
    }
}

void Games::guests()
{
    size_t person = 300;
    const auto sit = [&](double turn, double aside) {
        const double at = turn + aside / plan_.oval().radius(turn, guest_out_m);
        const Spot spot = plan_.oval().at(at, guest_out_m);
        scenes::Seat seat;
        seat.x = spot.x, seat.z = spot.z, seat.y = box_floor_m + guest_seat_m, seat.step_y = box_floor_m;
        seat.facing_x = -spot.out_x, seat.facing_z = -spot.out_z;
        const char *clips[] = {"sit", "sit_talk", "sit_look", "sit_lean"};
        const bool woman = random_unit(seed_, person, Purpose::clip) < 0.35;
        enter(woman ? "patrician" : "decurion",
              sit_down(seat, random_between(seed_, person, Purpose::heading, -7, 7), 0.97f),
              clips[random_bits(seed_, person, Purpose::act) % 4],
              random_between(seed_, person, Purpose::speed, 0.9, 1.1), person);
        ++person;
    };
    for (const double aside : guests_south) sit(south, aside);
    for (const double aside : guests_north) sit(north, aside);
}

void Games::place(double time_s)
{
    moved_.clear();
    for (size_t person = 0; person < walker_count; ++person) {
        clq_transform &place = crowd_.places()[first_ + person];
        place = walking(plan_, person, time_s, metres_per_s_, place.scale);
        moved_.push_back(place);
    }
    check(clq_crowd_set_transforms(crowd_.crowd(), crowd_.actors().data() + first_, moved_.data(), walker_count));
    lit_.clear();
    add_lit(first_, walker_count, lit_);
    lit_.insert(lit_.end(), lit_greeters_.begin(), lit_greeters_.end());
    shadows_.cast(lit_, exposure_.light().to_sun, 1.7f, 0.95f);
}

}  // namespace scenes::amphitheatre
