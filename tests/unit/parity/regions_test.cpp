// Comparison by regions: the inner pixels of one individual.
#include "samples/parity/regions.h"

#include <gtest/gtest.h>

#include "tests/unit/parity/test_pictures.h"

namespace parity
{
namespace
{

// Two columns of ids in 20 x 10: 1 left, 2 right; inner pixels are those not at the seam.
Map<uint64_t> halves()
{
    Map<uint64_t> out(20, 10, 1);
    for (int y = 0; y < 10; ++y)
        for (int x = 10; x < 20; ++x) out.values[out.index(x, y)] = 2;
    return out;
}

TEST(Regions, TheWorstOneIsFoundByItsMean)
{
    const Picture plain = filled(20, 10, 100);
    Picture other = plain;
    const Map<uint64_t> ids = halves();
    for (size_t i = 0; i < ids.values.size(); ++i)
        if (ids.values[i] == 2) other.rgb[3 * i + 1] = 104;
    other.rgb[0] = 200;
    const WorstRegion worst = worst_colour(ids, plain, other);
    EXPECT_EQ(worst.regions, 2u);
    EXPECT_EQ(worst.id, 2u);
    EXPECT_EQ(worst.pixels, 90u);
    EXPECT_DOUBLE_EQ(worst.value, 4);
}

TEST(Regions, WhatLiesAtABorderBelongsToNone)
{
    const Picture plain = filled(20, 10, 100);
    Picture other = plain;
    for (size_t y = 0; y < 10; ++y)
        for (size_t c = 0; c < 3; ++c) other.rgb[3 * (y * 20 + 10) + c] = 0;
    EXPECT_EQ(worst_colour(halves(), plain, other).value, 0);
}

TEST(Regions, SmallOnesAreIgnored)
{
    Map<uint64_t> ids(20, 10, 0);
    for (int y = 4; y < 8; ++y)
        for (int x = 4; x < 7; ++x) ids.values[ids.index(x, y)] = 7;  // 3 x 4: two inner pixels
    const Picture plain = filled(20, 10, 100), black = filled(20, 10, 0);
    EXPECT_EQ(worst_colour(ids, plain, black).regions, 1u);
    for (int y = 4; y < 8; ++y) ids.values[ids.index(7, y)] = 7;  // 4 x 4: four
    EXPECT_EQ(worst_colour(ids, plain, black).regions, 2u);
}

TEST(Regions, DepthGoesByMedians)
{
    Map<float> a(20, 10, 0.5f), b = a;
    const Map<uint64_t> ids = halves();
    for (size_t i = 0; i < ids.values.size(); ++i)
        if (ids.values[i] == 1) b.values[i] = 0.625f;
    b.values[19] = 0;
    const WorstRegion worst = worst_depth(ids, a, b);
    EXPECT_EQ(worst.id, 1u);
    EXPECT_EQ(worst.value, 0.125);
}

}  // namespace
}  // namespace parity
