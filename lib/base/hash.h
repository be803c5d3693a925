// The only source of randomness: hashes of (seed, id, purpose). They do not depend on the machine or on earlier calls.
#pragma once

#include <cstdint>

namespace claque::base
{

// One purpose per use, so that two samples of the same individual are not correlated by accident.
enum class Purpose : uint32_t {
    cache_phase = 1,
    hue = 2,
    saturation = 3,
    brightness = 4,
    clip = 5,
    speed = 6,
    phase = 7,
    position = 8,
    heading = 9,
    size = 10,
    pick = 11,
    map_class = 12,
    gaze = 13,
    expression = 14,
    blink = 15,
    phrase = 16,
    idle = 17,
    texture_set = 18
};

// A strong 64-bit mix (the finaliser of MurmurHash3, by Austin Appleby, public domain constants).
constexpr uint64_t mix(uint64_t x)
{
    x ^= x >> 33;
    x *= 0xff51afd7ed558ccdULL;
    x ^= x >> 33;
    x *= 0xc4ceb9fe1a85ec53ULL;
    x ^= x >> 33;
    return x;
}

constexpr uint64_t hash(uint64_t seed, uint64_t id, Purpose purpose, uint64_t index = 0)
{
    return mix(mix(mix(seed + 0x9e3779b97f4a7c15ULL) ^ id) + (static_cast<uint64_t>(purpose) << 32) + index);
}

// [0, 1), 24 bits, exact in float.
constexpr float unit(uint64_t h) { return static_cast<float>(h >> 40) * (1.0f / 16777216.0f); }

// Running FNV-1a over bytes, for hashes of results.
constexpr uint64_t fnv_start = 0xcbf29ce484222325ULL;
inline uint64_t fnv(uint64_t h, const void *bytes, uint64_t count)
{
    const unsigned char *p = static_cast<const unsigned char *>(bytes);
    for (uint64_t i = 0; i < count; ++i) h = (h ^ p[i]) * 0x100000001b3ULL;
    return h;
}

// The same over words of eight little-endian bytes, the last one filled up with zeros, in an eighth of the time. Each
// step is a bijection, so a change within one word always changes the result.
inline uint64_t fnv_words(uint64_t h, const uint8_t *bytes, uint64_t count)
{
    for (; count > 0;) {
        const uint64_t n = count < 8 ? count : 8;
        uint64_t word = 0;
        if (n == 8)
            for (int i = 0; i < 8; ++i) word |= uint64_t(bytes[i]) << (8 * i);
        else
            for (uint64_t i = 0; i < n; ++i) word |= uint64_t(bytes[i]) << (8 * i);
        h = (h ^ word) * 0x100000001b3ULL;
        h ^= h >> 32;
        bytes += n, count -= n;
    }
    return h;
}

}  // namespace claque::base
