// The programme of one member of the audience: an endless row of clips, picked at random, that is a function of the
// member and the time alone, so that any frame can be drawn by itself. Seated clips begin and end in one pose; they
// change at their ends only. Applause and laughter spread: their odds follow noise over place and time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "samples/scenes/odeon/temperament.h"

namespace scenes
{

enum class Act : uint8_t {
    sit,
    lean,
    look,
    talk,
    applaud,
    cheer,
    laugh,
    wave,
    rise,
    stand,
    stand_applaud,
    stand_cheer,
    stand_wave,
    stand_laugh,
    sit_down
};
constexpr size_t act_count = 15;  // the first seated_count are seated

const char *clip_name(Act act);

struct Member {
    uint64_t seed = 0, person = 0;
    double x = 0, z = 0;  // of the seat, metres
    // Sideways to the nearest sitter in the row in front. Rising or leaning forward needs room for head and chest.
    double aside_m = 9;
    Temperament temperament = Temperament::grave;
    std::array<double, act_count> duration_s = {};  // of its character's clips, each above 0
};

constexpr double aside_to_rise_m = 0.42, aside_to_lean_m = 0.18;

// One clip from its first pose to its last.
struct Playing {
    Act act = Act::sit;
    double begin_s = 0, end_s = 0;
    double speed = 1;
};

// The clip at a time: begin_s <= time_s < end_s.
Playing playing_at(const Member &member, double time_s);

}  // namespace scenes
