// What the tests of compressed data share: the seam of a build without a decoder, and damaged copies.
#pragma once

#include "assets.h"
#include "lib/asset/decoders.h"
#include "lib/base/hash.h"

namespace claque::testing
{

// Whether the build found the library. Where it did, a decoder that does not know of it is a failure.
inline bool was_found(asset::Decoder decoder)
{
    switch (decoder) {
#ifdef CLAQUE_HAS_DRACO
        case asset::Decoder::draco:
            return true;
#endif
#ifdef CLAQUE_HAS_MESHOPT
        case asset::Decoder::meshopt:
            return true;
#endif
#ifdef CLAQUE_HAS_WEBP
        case asset::Decoder::webp:
            return true;
#endif
        default:
            return false;
    }
}

#define CLAQUE_NEEDS_DECODER(decoder, library) \
    if (!claque::testing::was_found(decoder)) GTEST_SKIP() << "this build has no " << library

// Every outcome of damaged copies of bytes[first, first + size) must be a model or a sentence: truncations, which zero
// the rest, and changed bytes.
inline void expect_sentences(const Bytes &bytes, size_t first, size_t size, uint64_t runs, uint64_t seed,
                             const asset::LoadOptions &options = {})
{
    uint64_t loaded = 0, refused = 0;
    for (uint64_t run = 0; run < runs; ++run) {
        const auto roll = [&](uint64_t n) { return base::hash(seed + run, n, base::Purpose::pick); };
        Bytes damaged = bytes;
        if (run % 4 == 0) {
            const size_t from = roll(0) % size;
            std::fill_n(damaged.begin() + static_cast<std::ptrdiff_t>(first + from), size - from, uint8_t(0));
        }
        // Half of the damage goes to the first bytes, which decide how the rest is read.
        for (uint64_t k = 0; k < 1 + run % 3; ++k) {
            const size_t range = roll(3 * k + 1) % 2 ? size : std::min<size_t>(size, 64);
            damaged[first + roll(3 * k + 2) % range] = static_cast<uint8_t>(roll(3 * k + 3));
        }
        const Outcome outcome = outcome_of(damaged, options);
        outcome.status == 0 ? ++loaded : ++refused;
        if (outcome.status != 0) {
            EXPECT_NE(outcome.status, CLQ_ARGUMENT) << run << ": " << outcome.text;
            EXPECT_FALSE(outcome.text.empty()) << run;
        }
    }
    EXPECT_EQ(loaded + refused, runs);
    EXPECT_GT(refused, 0u);
}

}  // namespace claque::testing
