// Random choices are hashes of (seed of the stage, seed of the agent, purpose, count), so they depend neither on the
// machine nor on other agents.
#pragma once

#include <cstdint>
#include <cstring>

namespace claque::stage
{

// The finaliser of MurmurHash3 (Austin Appleby, public domain).
constexpr uint64_t mix(uint64_t x)
{
    x ^= x >> 33;
    x *= 0xff51afd7ed558ccdULL;
    x ^= x >> 33;
    x *= 0xc4ceb9fe1a85ec53ULL;
    x ^= x >> 33;
    return x;
}

constexpr uint64_t hash(uint64_t seed, uint64_t agent_seed, uint64_t purpose, uint64_t count)
{
    return mix(mix(mix(seed + 0x9e3779b97f4a7c15ULL) ^ agent_seed) + (purpose << 32) + count);
}

// [0, 1), 53 bits.
constexpr double unit(uint64_t h) { return static_cast<double>(h >> 11) * (1.0 / 9007199254740992.0); }

constexpr uint64_t start_of_sum = 0xcbf29ce484222325ULL;

// Running hashes of results.
constexpr uint64_t sum(uint64_t h, uint64_t word) { return mix(h ^ word) + 0x9e3779b97f4a7c15ULL; }
inline uint64_t sum(uint64_t h, double number)
{
    uint64_t bits;
    std::memcpy(&bits, &number, sizeof bits);
    return sum(h, bits);
}

}  // namespace claque::stage
