#include "samples/scenes/amphitheatre/acclaim.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/random.h"

namespace scenes::amphitheatre
{
namespace
{

constexpr double jitter_s = 4, reaction_s = 0.9;
constexpr double shortest_s = 6, longest_s = 10.5;  // of an acclamation, of one spectator
constexpr double shortest_stand_s = 3.4;
constexpr double quiet_s = 8;                       // about the length of a quiet clip
constexpr double source_x_m = 70, source_z_m = 55;  // where waves start

uint64_t of(int64_t number, uint64_t person)
{
    return person * 0x10001u + static_cast<uint64_t>(number) * 0x9e3779b97f4a7c15u;
}

// One clip a whole number of times within a stretch of time.
Playing fitted(const Spectator &s, Act act, double begin_s, double end_s)
{
    const double duration = s.duration_s[static_cast<size_t>(act)], length = end_s - begin_s;
    const double loops = std::max(1.0, std::floor(length / duration + 0.5));
    return {act, begin_s, end_s, loops * duration / length};
}

Act chosen(const std::array<double, seated_count> &weights, double at)
{
    double sum = 0;
    for (const double weight : weights) sum += weight;
    at *= sum;
    for (size_t i = 0; i + 1 < seated_count; ++i) {
        if (at < weights[i]) return static_cast<Act>(i);
        at -= weights[i];
    }
    return Act::wave;
}

// The clip at a time within a quiet stretch.
Playing quiet(const Spectator &s, int64_t number, double begin_s, double end_s, double time_s)
{
    const double pace = random_between(s.seed, s.person, Purpose::speed, 0.85, 1.2);
    const double slots = std::max(1.0, std::floor((end_s - begin_s) * pace / quiet_s + 0.5));
    const double each = (end_s - begin_s) / slots;
    const double slot = std::clamp(std::floor((time_s - begin_s) / each), 0.0, slots - 1);
    std::array<double, seated_count> weights = s.temperament.odds;
    weights[1] *= random_between(s.seed, s.person, Purpose::temper, 0.2, 1.4);
    weights[3] *= random_between(s.seed, s.person + 0x100000u, Purpose::temper, 0.3, 2.0);
    const Act act =
        chosen(weights, random_unit(s.seed, of(number, s.person) + static_cast<uint64_t>(slot), Purpose::act));
    const double first = begin_s + slot * each, last = slot + 1 < slots ? begin_s + (slot + 1) * each : end_s;
    return fitted(s, act, first, last);
}

// The clip at a time within an acclamation.
Playing excited(const Spectator &s, int64_t number, double begin_s, double end_s, double time_s)
{
    const uint64_t id = of(number, s.person);
    const double strength = wave(s.seed, number).strength;
    const auto draw = [&](uint64_t k) { return random_unit(s.seed, id + k, Purpose::temper); };
    const double up = s.duration_s[static_cast<size_t>(Act::rise)],
                 down = s.duration_s[static_cast<size_t>(Act::sit_down)];
    if (end_s - begin_s > up + down + shortest_stand_s && draw(1) < 0.55 * s.temperament.rise * strength) {
        if (time_s < begin_s + up) return {Act::rise, begin_s, begin_s + up, 1};
        if (time_s >= end_s - down) return {Act::sit_down, end_s - down, end_s, 1};
        const double at = draw(2);
        const Act act = at < 0.45 ? Act::stand_cheer : at < 0.75 ? Act::stand_wave : Act::stand_applaud;
        return fitted(s, act, begin_s + up, end_s - down);
    }
    const std::array<double, seated_count> weights = {0, 0, 0, 0, 1.6, 0.5 + s.temperament.cheer, 0.15, 0.7};
    return fitted(s, chosen(weights, draw(3)), begin_s, end_s);
}

}  // namespace

Wave wave(uint64_t seed, int64_t number)
{
    const uint64_t id = static_cast<uint64_t>(number);
    const double turn = 6.283185307179586 * random_unit(seed, id, Purpose::heading);
    return {static_cast<double>(number) * wave_every_s + random_between(seed, id, Purpose::gap, -jitter_s, jitter_s),
            source_x_m * std::cos(turn), source_z_m * std::sin(turn),
            random_between(seed, id, Purpose::tries, 0.55, 1)};
}

double arrival_s(const Spectator &s, int64_t number)
{
    const Wave w = wave(s.seed, number);
    const double dx = s.x - w.x, dz = s.z - w.z;
    return w.start_s + std::sqrt(dx * dx + dz * dz) / wave_m_per_s +
           random_between(s.seed, of(number, s.person), Purpose::phase, 0, reaction_s);
}

double odds_of_joining(const Spectator &s, int64_t number)
{
    const Wave w = wave(s.seed, number);
    const double dx = s.x - w.x, dz = s.z - w.z, away = std::sqrt(dx * dx + dz * dz);
    return std::clamp((1.25 - away / 190) * w.strength * (0.55 + 0.08 * s.temperament.cheer), 0.05, 0.95);
}

Playing playing_at(const Spectator &s, double time_s)
{
    int64_t number = static_cast<int64_t>(std::floor(time_s / wave_every_s)) + 1;
    double begin = arrival_s(s, number), next = begin;
    while (begin > time_s) next = begin, begin = arrival_s(s, --number);
    if (next == begin) next = arrival_s(s, number + 1);
    const uint64_t id = of(number, s.person);
    if (random_unit(s.seed, id, Purpose::tries) >= odds_of_joining(s, number))
        return quiet(s, number, begin, next, time_s);
    const double end = begin + random_between(s.seed, id, Purpose::speed, shortest_s, longest_s);
    return time_s < end ? excited(s, number, begin, end, time_s) : quiet(s, number, end, next, time_s);
}

}  // namespace scenes::amphitheatre
