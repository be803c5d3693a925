#include "samples/scenes/odeon/programme.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/odeon/noise.h"
#include "samples/scenes/random.h"

namespace scenes
{
namespace
{

// A programme is cut into blocks of this length, each a row of whole clips that fills it, so that any time is found
// without following the programme from its beginning. Blocks of different individuals begin at different times.
constexpr double block_s = 32;
constexpr size_t most_acts = 64;

double above(double value, double from, double to) { return std::clamp((value - from) / (to - from), 0.0, 1.0); }

struct Mood {
    double applause, ovation, mirth;  // [0, 1]
};

// Applause has patches some eight metres wide and a part common to the whole house; mirth has smaller patches.
Mood mood_at(const Member &m, double time_s)
{
    const double patch = gradient_noise(m.seed + 1, m.x / 8, m.z / 8, time_s / 13);
    const double house = gradient_noise(m.seed + 2, 0.5, 0.5, time_s / 21);
    const double jest = gradient_noise(m.seed + 3, m.x / 5, m.z / 5, time_s / 9);
    const double applause = patch + 0.5 * house;
    return {above(applause, 0.08, 0.34), above(applause, 0.22, 0.5), above(jest, 0.10, 0.36)};
}

struct Block {
    std::array<Act, most_acts> acts;
    size_t count = 0;
    double total_s = 0;  // at speed 1
};

class Writer
{
public:
    Writer(const Member &member, int64_t number, double begin_s)
        : m_(member), number_(static_cast<uint64_t>(number)), begin_s_(begin_s)
    {
        const double pace = random_between(m_.seed, m_.person, Purpose::speed, 0.92, 1.08);
        wanted_s_ = block_s * pace;
        shortest_s_ = *std::min_element(m_.duration_s.begin(), m_.duration_s.begin() + 4);
    }

    Block write()
    {
        while (left() > 0.5 * shortest_s_ && block_.count + 5 < most_acts) {
            const Mood mood = mood_at(m_, begin_s_ + block_.total_s * block_s / wanted_s_);
            if (!stand_up(mood)) add(left() > 9 ? seated(mood) : best_fit());
        }
        return block_;
    }

private:
    double left() const { return wanted_s_ - block_.total_s; }
    double duration(Act act) const { return m_.duration_s[static_cast<size_t>(act)]; }
    double draw()
    {
        return random_unit(m_.seed, m_.person * 0x10001u + number_ * 0x9e3779b97f4a7c15u + draws_++, Purpose::act);
    }
    void add(Act act)
    {
        block_.acts[block_.count++] = act;
        block_.total_s += duration(act);
    }

    Act seated(const Mood &mood)
    {
        const Temperament &temperament = m_.temperament;
        std::array<double, seated_count> weights = temperament.odds;
        // Some are restless, some talkative, some hold still.
        const double restless = random_between(m_.seed, m_.person, Purpose::temper, 0.4, 1.8);
        const double talkative = random_between(m_.seed, m_.person + 0x100000u, Purpose::temper, 0.3, 2.0);
        weights[1] *= m_.aside_m < aside_to_lean_m ? 0 : restless;
        weights[2] *= restless;
        weights[3] *= talkative;
        weights[4] += 22 * mood.applause;
        weights[5] += temperament.cheer * mood.ovation;
        weights[6] += temperament.laugh * mood.mirth;
        weights[7] += 0.5 * temperament.cheer * mood.ovation;
        double sum = 0;
        for (const double w : weights) sum += w;
        double at = draw() * sum;
        for (size_t i = 0; i + 1 < seated_count; ++i) {
            if (at < weights[i]) return static_cast<Act>(i);
            at -= weights[i];
        }
        return Act::wave;
    }

    // Rises, stays up for a clip or two, sits down again; returns false if it stays seated.
    bool stand_up(const Mood &mood)
    {
        const double ready = m_.temperament.rise;
        if (m_.aside_m < aside_to_rise_m || draw() >= ready * (0.13 + 0.35 * mood.ovation)) return false;
        constexpr Act ovation[] = {Act::stand_applaud, Act::stand_applaud, Act::stand_cheer, Act::stand_wave};
        constexpr Act else_[] = {Act::stand, Act::stand_wave, Act::stand_laugh, Act::stand_applaud};
        const Act(&choice)[4] = mood.ovation > 0.1 ? ovation : else_;
        const Act first = choice[static_cast<size_t>(draw() * 4)], second = choice[static_cast<size_t>(draw() * 4)];
        const bool twice = draw() < 0.6;
        const double needs =
            duration(Act::rise) + duration(first) + (twice ? duration(second) : 0) + duration(Act::sit_down);
        if (needs > left()) return false;
        add(Act::rise);
        add(first);
        if (twice) add(second);
        add(Act::sit_down);
        return true;
    }

    // Near the end of a block: the quiet clip that leaves the smallest gap, so that speeds stay near 1.
    Act best_fit()
    {
        const size_t first = static_cast<size_t>(draw() * 4);
        Act best = Act::sit;
        double least = 1e9;
        for (size_t i = 0; i < 4; ++i) {
            const Act act = static_cast<Act>((first + i) % 4);
            if (act == Act::lean && m_.aside_m < aside_to_lean_m) continue;
            double missing = left() - duration(act);
            if (missing > 0) missing = std::min(missing, std::abs(missing - shortest_s_));
            if (std::abs(missing) >= least - 1e-9) continue;
            least = std::abs(missing);
            best = act;
        }
        return best;
    }

    const Member &m_;
    uint64_t number_;
    double begin_s_, wanted_s_, shortest_s_;
    uint64_t draws_ = 0;
    Block block_;
};

}  // namespace

const char *clip_name(Act act)
{
    constexpr const char *names[act_count] = {
        "sit",  "sit_lean", "sit_look",      "sit_talk",    "sit_applaud", "sit_cheer",   "sit_laugh", "sit_wave",
        "rise", "stand",    "stand_applaud", "stand_cheer", "stand_wave",  "stand_laugh", "sit_down"};
    return names[static_cast<size_t>(act)];
}

Playing playing_at(const Member &member, double time_s)
{
    const double shift = random_unit(member.seed, member.person, Purpose::phase) * block_s;
    const int64_t number = static_cast<int64_t>(std::floor((time_s + shift) / block_s));
    const double begin = static_cast<double>(number) * block_s - shift;
    const Block block = Writer(member, number, begin).write();
    // Scales the speed of all clips so that they fill the block.
    const double second = block_s / block.total_s;
    Playing playing;
    playing.speed = block.total_s / block_s;
    playing.end_s = begin;
    for (size_t i = 0; i < block.count; ++i) {
        playing.act = block.acts[i];
        playing.begin_s = playing.end_s;
        playing.end_s += member.duration_s[static_cast<size_t>(playing.act)] * second;
        if (time_s < playing.end_s) return playing;
    }
    playing.end_s = begin + block_s;  // avoids the rounding error of the sum above
    return playing;
}

}  // namespace scenes
