// The frames of a film among processes: each once, and those that follow each other with one process.
#include "samples/processes/frame_shares.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace
{

using processes::FrameShares;

std::vector<std::vector<size_t>> dealt(FrameShares shares, const std::vector<uint32_t> &asking, uint32_t workers)
{
    std::vector<std::vector<size_t>> out(workers);
    for (const uint32_t worker : asking)
        if (const std::optional<size_t> frame = shares.next(worker)) out[worker].push_back(*frame);
    return out;
}

size_t breaks(const std::vector<size_t> &frames)
{
    size_t found = 0;
    for (size_t i = 1; i < frames.size(); ++i) found += frames[i] != frames[i - 1] + 1;
    return found;
}

TEST(FrameShares, HaveEachFrameOnce)
{
    for (const bool in_order : {false, true})
        for (const size_t frames : {0u, 1u, 5u, 97u})
            for (const uint32_t workers : {1u, 2u, 7u, 200u}) {
                std::vector<uint32_t> asking;
                for (uint32_t i = 0; i < 2 * frames + 400; ++i) asking.push_back(i * i * 7 % 13 % workers);
                std::vector<size_t> all;
                for (const std::vector<size_t> &some : dealt({frames, workers, in_order}, asking, workers))
                    all.insert(all.end(), some.begin(), some.end());
                std::sort(all.begin(), all.end());
                ASSERT_EQ(all.size(), frames) << workers << " workers";
                for (size_t i = 0; i < frames; ++i) EXPECT_EQ(all[i], i);
            }
}

TEST(FrameShares, KeepNeighboursTogether)
{
    std::vector<uint32_t> in_turn, one_is_slow;
    for (uint32_t i = 0; i < 400; ++i) in_turn.push_back(i % 4), one_is_slow.push_back(i % 40 == 0 ? 3 : i % 3);
    for (const std::vector<size_t> &frames : dealt({200, 4, false}, in_turn, 4)) {
        EXPECT_EQ(frames.size(), 50u);
        EXPECT_EQ(breaks(frames), 0u);
    }
    // What is left of a slow worker is halved each time, so that no frames are scattered.
    const auto shared = dealt({200, 4, false}, one_is_slow, 4);
    EXPECT_LT(shared[3].size(), 20u);
    for (const std::vector<size_t> &frames : shared) EXPECT_LE(breaks(frames), 8u);
}

TEST(FrameShares, OfAStreamAreDealtInOrder)
{
    FrameShares shares(9, 3, true);
    for (size_t i = 0; i < 9; ++i) EXPECT_EQ(shares.next(static_cast<uint32_t>(i * 2 % 3)), i);
    EXPECT_EQ(shares.next(1), std::nullopt);
}

}  // namespace
