// What a spectator plays at a time. Acclamations run through the rows as waves: each starts somewhere at its time and
// comes to every seat with a speed, so that it is a function of time and place. Between two waves a spectator plays
// quiet clips, a whole number of them, each paced so that they fill the time. All clips begin and end in one seated
// pose, so nothing jumps. Any time is found without the times before it.
#pragma once

#include "samples/scenes/odeon/programme.h"

namespace scenes::amphitheatre
{

struct Spectator {
    uint64_t seed = 0, person = 0;
    double x = 0, z = 0;
    Temperament temperament = Temperament::grave;
    std::array<double, act_count> duration_s = {};  // of its character's clips, each above 0
};

struct Wave {
    double start_s, x, z;
    double strength;  // [0, 1]
};

constexpr double wave_every_s = 40, wave_m_per_s = 30;

// Waves have numbers, which may be negative.
Wave wave(uint64_t seed, int64_t number);
// When it comes to a spectator, with the spectator's time of reaction.
double arrival_s(const Spectator &spectator, int64_t number);
// The odds that a spectator joins in, [0, 1].
double odds_of_joining(const Spectator &spectator, int64_t number);

// begin_s <= time_s < end_s.
Playing playing_at(const Spectator &spectator, double time_s);

}  // namespace scenes::amphitheatre
