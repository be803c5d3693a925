// Random numbers that are functions of (seed, individual, purpose) and nothing else, so that a scene is the same on
// every machine and does not change when individuals are added to it.
#pragma once

#include <cstdint>

namespace scenes
{

enum class Purpose : uint32_t {
    place_x,
    place_z,
    tries,
    heading,
    clip,
    phase,
    speed,
    size,
    group_size,
    lane,
    gap,
    radius,
    row,
    slab,
    tone,
    grain,
    tree,
    seat,
    temper,
    act,
    gradient
};

inline uint64_t random_bits(uint64_t seed, uint64_t id, Purpose purpose)
{
    uint64_t bits = seed * 0x9e3779b97f4a7c15u ^ (id + 1) * 0xd1b54a32d192ed03u ^
                    (static_cast<uint64_t>(purpose) + 1) * 0x8cb92ba72f3d8dd7u;
    for (int round = 0; round < 2; ++round) {
        bits ^= bits >> 31;
        bits *= 0x7fb5d329728ea185u;
        bits ^= bits >> 27;
        bits *= 0x81dadef4bc2dd44du;
        bits ^= bits >> 33;
    }
    return bits;
}

// In [0, 1).
inline double random_unit(uint64_t seed, uint64_t id, Purpose purpose)
{
    return static_cast<double>(random_bits(seed, id, purpose) >> 11) * (1.0 / 9007199254740992.0);
}

inline double random_between(uint64_t seed, uint64_t id, Purpose purpose, double min, double max)
{
    return min + (max - min) * random_unit(seed, id, purpose);
}

}  // namespace scenes
