// Random numbers of samples: each is a hash of (seed, sample, purpose, attempt). So any sample can be made alone, and a
// new rule leaves the choices of the others as they are. Purposes are the names of rules; scenes/random.h has a fixed
// list of them.
#pragma once

#include <cstdint>
#include <string_view>

namespace labels
{

inline uint64_t chance_bits(uint64_t seed, uint32_t sample, std::string_view purpose, uint32_t attempt = 0)
{
    uint64_t bits = 0;
    const auto stir = [&](uint64_t with) {
        bits = (bits ^ with) + 0x9e3779b97f4a7c15u;
        bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9u;
        bits = (bits ^ bits >> 27) * 0x94d049bb133111ebu;
        bits ^= bits >> 31;
    };
    stir(seed), stir(sample), stir(attempt);
    for (const char letter : purpose) stir(static_cast<unsigned char>(letter));
    return bits;
}

// In [0, 1).
inline double chance(uint64_t seed, uint32_t sample, std::string_view purpose, uint32_t attempt = 0)
{
    return static_cast<double>(chance_bits(seed, sample, purpose, attempt) >> 11) * (1.0 / 9007199254740992.0);
}

}  // namespace labels
