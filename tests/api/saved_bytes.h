// Saved crowds as bytes in memory, and forged ones: changed bytes under a corrected hash.
#pragma once

#include <claque/claque.h>

#include <vector>

#include <gtest/gtest.h>

namespace saved
{

using Bytes = std::vector<uint8_t>;

constexpr size_t header_bytes = 32;

inline Bytes save(const clq_crowd *crowd)
{
    Bytes out;
    const auto keep = [](void *user, const void *bytes, size_t size) {
        const uint8_t *first = static_cast<const uint8_t *>(bytes);
        static_cast<Bytes *>(user)->insert(static_cast<Bytes *>(user)->end(), first, first + size);
        return 0;
    };
    EXPECT_EQ(clq_crowd_save(crowd, keep, &out), CLQ_OK) << clq_last_error();
    return out;
}

inline void put(Bytes &bytes, size_t at, uint64_t value, size_t size)
{
    for (size_t i = 0; i < size; ++i) bytes[at + i] = static_cast<uint8_t>(value >> (8 * i));
}

inline void forge(Bytes &bytes)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = header_bytes; i < bytes.size(); ++i) hash = (hash ^ bytes[i]) * 0x100000001b3u;
    put(bytes, 16, bytes.size() - header_bytes, 8);
    put(bytes, 24, hash, 8);
}

}  // namespace saved
