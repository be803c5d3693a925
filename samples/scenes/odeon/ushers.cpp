#include "samples/scenes/odeon/ushers.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/odeon/floor.h"
#include "samples/scenes/random.h"

namespace scenes
{
namespace
{

// People rather go a few metres farther than into the crowd before a gangway.
constexpr double per_guest_m = 0.9;

}  // namespace

Ushers::Ushers(const Theatre &theatre, uint64_t seed)
    : theatre_(theatre),
      seed_(seed),
      seats_(seats_of(theatre)),
      benches_(benches_of(theatre, seats_)),
      outside_(entrances_of(theatre)),
      rows_(benches_.size())
{
}

const std::vector<std::string> &Ushers::questions()
{
    static const std::vector<std::string> all = {"ask_bench", "ask_seat", "ask_leave", "leave_seat", "ask_way_out"};
    return all;
}

void Ushers::ask(size_t question, size_t guest, const Send &send)
{
    constexpr void (Ushers::*answers[])(size_t) = {&Ushers::give_bench, &Ushers::give_seat, &Ushers::let_go,
                                                   &Ushers::take_back, &Ushers::show_out};
    send_ = &send;
    (this->*answers[question])(guest);
}

size_t Ushers::add(const Spectator &spectator)
{
    Guest guest;
    guest.person = spectator;
    guests_.push_back(guest);
    return guests_.size() - 1;
}

size_t Ushers::seat_of(size_t spectator) const
{
    const Guest &guest = guests_[spectator];
    return guest.slot == nowhere ? nowhere : benches_[guest.bench].seats[guest.slot];
}

clq_transform Ushers::place_of(size_t seat, float scale) const
{
    return sit_down(seats_[seat], facing_turn_deg(theatre_, seats_[seat], seed_), scale);
}

void Ushers::answer(const char *event, size_t guest, const std::array<double, 3> &place, double value) const
{
    (*send_)({guest, event, place, value});
}

double Ushers::way_m(const Guest &guest, size_t number) const
{
    const Bench &bench = benches_[number];
    const double angle = bench.gangway_deg * radians, radius = theatre_.orchestra_radius_m;
    const double x = radius * std::sin(angle), z = -radius * std::cos(angle);
    double way = std::hypot(x - guest.person.entrance[0], z - guest.person.entrance[2]) + bench.climb_m;
    // Guests on their way to the same gangway.
    for (size_t other = 0; other < benches_.size(); ++other)
        if (benches_[other].gangway_deg == bench.gangway_deg)
            way += per_guest_m * double(rows_[other].promised - rows_[other].sitting.size());
    return way;
}

void Ushers::give_bench(size_t number)
{
    Guest &guest = guests_[number];
    const std::string &own = guest.person.social_class;
    size_t best = nowhere;
    double least = 1e300;
    for (size_t i = 0; i < benches_.size(); ++i) {
        if (benches_[i].social_class != own || rows_[i].promised >= benches_[i].seats.size()) continue;
        const double way = way_m(guest, i);
        if (way < least) least = way, best = i;
    }
    if (best == nowhere || guest.bench != nowhere) return answer("full", number, guest.person.entrance);
    guest.bench = best;
    ++rows_[best].promised;
    answer("bench", number, benches_[best].entry);
}

void Ushers::give_seat(size_t number)
{
    Guest &guest = guests_[number];
    if (guest.bench == nowhere || guest.slot != nowhere) return answer("full", number, guest.person.entrance);
    guest.slot = rows_[guest.bench].sitting.size();
    rows_[guest.bench].sitting.push_back(number);
    const clq_transform place = place_of(seat_of(number), guest.person.scale);
    const double heading =
        2 * std::atan2(double(place.orientation_xyzw[1]), double(place.orientation_xyzw[3])) / radians;
    answer("seat", number, {place.position[0], place.position[1], place.position[2]}, heading);
}

// The others on its bench sit between it and the gangway.
bool Ushers::is_shut_in(const Guest &guest) const { return guest.slot + 1 < rows_[guest.bench].sitting.size(); }

void Ushers::let_go(size_t number)
{
    Guest &guest = guests_[number];
    if (guest.slot == nowhere) return answer("free", number, guest.person.entrance);
    guest.waits = true;
    free_last(guest.bench);
}

void Ushers::free_last(size_t bench)
{
    if (rows_[bench].sitting.empty()) return;
    const size_t last = rows_[bench].sitting.back();
    Guest &guest = guests_[last];
    if (!guest.waits) return;
    guest.waits = false;
    const clq_transform place = place_of(seat_of(last), guest.person.scale);
    answer("free", last, {place.position[0], place.position[1], place.position[2]});
}

void Ushers::take_back(size_t number)
{
    Guest &guest = guests_[number];
    if (guest.bench == nowhere) return;
    const size_t bench = guest.bench;
    if (guest.slot != nowhere && is_shut_in(guest)) return;
    if (guest.slot != nowhere) rows_[bench].sitting.pop_back();
    --rows_[bench].promised;
    guest.bench = guest.slot = nowhere;
    free_last(bench);
}

void Ushers::show_out(size_t number)
{
    const Guest &guest = guests_[number];
    const std::array<double, 3> &in = guest.person.entrance;
    const double aside = random_between(seed_, number, Purpose::lane, -0.8, 0.8);
    // On the side on which one came.
    std::array<double, 3> out = outside_[number % outside_.size()];
    out[0] = std::copysign(std::abs(out[0]), in[0]) + aside;
    out[2] += random_between(seed_, number, Purpose::gap, -0.5, 1.2);
    answer("way_out", number, out);
}

}  // namespace scenes
