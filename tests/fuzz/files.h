// Several files in one input: for each its number, the length of its bytes (2 bytes) and its bytes.
#pragma once

#include <utility>

#include "tests/fuzz/fuzzer.h"

namespace fuzzing
{

using Files = std::vector<std::pair<uint8_t, Bytes>>;

inline Files files_of(const uint8_t *bytes, size_t size)
{
    Files out;
    for (Feed feed(bytes, size); feed.left() > 3;) {
        const uint8_t number = feed.take<uint8_t>();
        const uint16_t length = feed.take<uint16_t>();
        out.emplace_back(number, feed.bytes(length));
    }
    return out;
}

inline Bytes packed(const Files &files)
{
    Bytes out;
    for (const auto &[number, bytes] : files) {
        const size_t size = bytes.size() < 0xffff ? bytes.size() : 0xffff;
        out.insert(out.end(), {number, static_cast<uint8_t>(size), static_cast<uint8_t>(size >> 8)});
        out.insert(out.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    }
    return out;
}

}  // namespace fuzzing
